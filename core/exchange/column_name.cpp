#include "core/exchange/column_name.h"

#include <algorithm>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/typed_text.h"
#include "core/exchange/heading_words.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

using Role = HeadingRole;

/// The name of a tilt such as `Cross tilt ["]` or `tilt_length_arcsec`. Tilts in other units are ignored.
std::optional<ColumnName> tiltName(const std::vector<std::string>& words) {
  bool isTilt = false;
  std::string Reading::*axis = nullptr;
  for (const std::string& word : words) {
    if (means(Role::Tilt, word))
      isTilt = true;
    else if (means(Role::CrossTilt, word))
      axis = &Reading::tiltCrossArcsec;
    else if (means(Role::LengthTilt, word))
      axis = &Reading::tiltLengthArcsec;
    else if (!means(Role::Arcseconds, word))
      return std::nullopt;
  }
  if (!isTilt || !axis) return std::nullopt;
  ColumnName name;
  name.column = TableColumn{&rowField(axis)};
  name.isUnderstood = true;
  return name;
}

/// The field that a single word names, apart from the circles.
std::optional<TableColumn> plainColumn(std::string_view word) {
  using Other = TableColumn::Other;
  for (const auto& [role, other] : {std::pair(Role::Axis, Other::Axis), std::pair(Role::Turn, Other::Turn),
                                    std::pair(Role::Station, Other::Station)})
    if (means(role, word)) return TableColumn{nullptr, other};
  for (const auto& [role, text] :
       {std::pair(Role::Point, &Reading::point), std::pair(Role::Round, &Reading::round),
        std::pair(Role::Face, &Reading::face), std::pair(Role::Slider, &Reading::slider),
        std::pair(Role::Corrections, &Reading::corrections), std::pair(Role::Note, &Reading::note)})
    if (means(role, word)) return TableColumn{&rowField(text)};
  if (means(Role::Excluded, word)) return TableColumn{&rowField(&Reading::excluded)};
  return std::nullopt;
}

bool isCircleWord(std::string_view word) {
  return means(Role::Horizontal, word) || means(Role::MaybeHorizontal, word) || means(Role::Vertical, word) ||
         means(Role::MaybeVertical, word) || means(Role::Zenith, word) || means(Role::Elevation, word);
}

bool isFaceOrPart(std::string_view word) {
  return means(Role::FaceOne, word) || means(Role::FaceTwo, word) || means(Role::MinutePart, word) ||
         means(Role::SecondPart, word) || means(Role::DegreePart, word) || means(Role::GonMinutePart, word) ||
         means(Role::GonSecondPart, word);
}

bool isKnown(std::string_view word) {
  return isCircleWord(word) || isFaceOrPart(word) || plainColumn(word) || means(Role::Numbering, word) ||
         means(Role::Distance, word) || means(Role::HorizontalDistance, word) ||
         means(Role::DistanceWord, word) || means(Role::Gon, word) || means(Role::Degrees, word) ||
         means(Role::Radians, word) || means(Role::Dms, word) || means(Role::Metre, word) ||
         means(Role::Millimetre, word) || means(Role::Filler, word) || means(Role::CircleWord, word);
}

/// Splits HzI, hz1 and Lage2 into two words each. VD, a vertical distance, stays whole.
std::vector<std::string> withoutSuffixes(const std::vector<std::string>& words) {
  std::vector<std::string> parted;
  for (const std::string& word : words) {
    std::size_t at = isKnown(word) || word == "vd" ? 0 : word.size() - 1;
    const auto isParted = [&word](std::size_t end) {
      const std::string_view head = std::string_view(word).substr(0, end),
                             tail = std::string_view(word).substr(end);
      return (isCircleWord(head) || means(Role::Face, head)) && isFaceOrPart(tail);
    };
    while (at > 0 && !isParted(at)) --at;
    if (at > 0) parted.push_back(word.substr(0, at));
    parted.push_back(word.substr(at));
  }
  return parted;
}

/// Combines the meanings of the words of one heading.
class NameReader {
 public:
  explicit NameReader(const std::vector<std::string>& words) : m_words(withoutSuffixes(words)) {}

  ColumnName read() {
    findKinds();
    if (takeDistance()) return std::move(m_name);
    takeCircle();
    for (const std::string& word : m_words) takeWord(word);
    if (!m_name.column && m_isCircleNamed && m_isFaceless && !m_name.isPart)
      m_name.column = TableColumn{&rowField(&Reading::face)};
    if (!m_name.column && m_counts && !m_name.isPart) {
      m_name.column = TableColumn{&rowField(&Reading::point)};
      m_name.isWeak = true;
    }
    takeParts();
    m_name.isUnderstood = !m_words.empty() && !m_isStrange;
    if (m_isStrange) {
      m_name.column.reset();
      m_name.face = 0;
    }
    return std::move(m_name);
  }

 private:
  bool any(Role role) const {
    return std::ranges::any_of(m_words, [role](const std::string& word) { return means(role, word); });
  }

  void findKinds() {
    m_isZenith = any(Role::Zenith);
    m_isElevation = any(Role::Elevation);
    m_isVertical = m_isZenith || m_isElevation || any(Role::Vertical);
    m_isHorizontal = any(Role::Horizontal);
  }

  /// Takes the name of a distance such as `slope distance [mm]` or `HD`; false for other names, and for names
  /// with an unknown word. A zenith distance is an angle.
  bool takeDistance() {
    if (m_isZenith) return false;
    ColumnName name;
    for (const std::string& word : m_words) {
      const bool isLetter = m_isHorizontal && (word == "s" || word == "d");  // the s of `Hz s` means seconds
      if (!isLetter && (means(Role::Distance, word) || means(Role::HorizontalDistance, word))) {
        name.column = TableColumn{nullptr, TableColumn::Other::Distance};
        name.isHorizontal = name.isHorizontal || means(Role::HorizontalDistance, word);
      } else if (means(Role::Horizontal, word)) {
        name.isHorizontal = true;
      } else if (means(Role::Millimetre, word)) {
        name.metres = 1e-3;
      } else if (!means(Role::Metre, word) && !means(Role::DistanceWord, word)) {
        return false;
      }
    }
    if (!name.column) return false;
    name.isUnderstood = true;
    m_name = std::move(name);
    return true;
  }

  void takeCircle() {
    if (m_isVertical && m_isHorizontal) {
      m_isStrange = true;
    } else if (m_isVertical) {
      m_name.column = TableColumn{&rowField(&Reading::vertical)};
      if (m_isElevation) m_name.verticalCircle = "elevation";
      if (m_isZenith) m_name.verticalCircle = "zenith";
    } else if (m_isHorizontal) {
      m_name.column = TableColumn{&rowField(&Reading::horizontal)};
    } else if (any(Role::MaybeHorizontal) || any(Role::MaybeVertical)) {
      const bool isVertical = any(Role::MaybeVertical);
      m_name.column = TableColumn{&rowField(isVertical ? &Reading::vertical : &Reading::horizontal)};
      m_name.isWeak = true;
    }
    m_isOfCircle = m_name.column.has_value();
  }

  bool isOfOther(const std::optional<TableColumn>& column) const { return column && column != m_name.column; }

  /// Adds the meaning of a word that does not name a circle.
  void takeWord(const std::string& word) {
    if (isCircleWord(word)) return;
    if (m_isZenith && means(Role::Distance, word)) return;
    const std::optional<TableColumn> column = plainColumn(word);
    const bool isOfFace = column && column->isOf(&Reading::face);
    m_name.isSpanish = m_name.isSpanish || means(Role::SpanishCircle, word);
    if (isOfFace && m_isOfCircle) return;
    if (takeUnit(word)) return;
    if (isOfFace || !takeFace(word, m_isOfCircle)) takeColumn(word, column);
  }

  void takeColumn(const std::string& word, const std::optional<TableColumn>& column) {
    if (means(Role::CircleWord, word))
      m_isCircleNamed = true;
    else if (column && !m_name.column)
      m_name.column = column;
    else if (!isOfOther(column) && means(Role::Numbering, word))
      m_counts = true;
    else if (isOfOther(column) || (!column && !takeFace(word, true) && !saysNothing(word)))
      m_isStrange = true;
  }

  /// Is the word a filler, or a unit that adds nothing, such as the degrees of the axis angle?
  static bool saysNothing(std::string_view word) {
    return means(Role::Filler, word) || means(Role::Metre, word) || means(Role::Millimetre, word) ||
           means(Role::Degrees, word);
  }

  /// Adds the face that a word names; false if it names none. 1 and 2 count only with a circle or a field.
  bool takeFace(const std::string& word, bool isOfCircle) {
    const bool isOne = means(Role::FaceOne, word), isTwo = means(Role::FaceTwo, word);
    const bool isNumber = word == "1" || word == "2";
    if ((!isOne && !isTwo) || (isNumber && !isOfCircle && !m_isCircleNamed && !m_name.column)) return false;
    m_name.face = isOne ? 1 : 2;
    m_isFaceless = false;
    if (m_name.column && m_name.column->isOf(&Reading::face)) m_name.column.reset();
    return true;
  }

  /// Adds a unit or a part of an angle; `takeParts` decides which of them it is. False for other words.
  bool takeUnit(const std::string& word) {
    bool isTaken = false;
    const auto take = [&](Role role, bool& is) {
      if (!means(role, word)) return;
      is = true;
      isTaken = true;
    };
    if (m_name.column && !m_isOfCircle && !isAngle(*m_name.column)) return false;
    if (means(Role::Degrees, word)) m_name.unit = AngleUnit::Degrees;
    if (means(Role::Gon, word)) m_name.unit = AngleUnit::Gon;
    if (means(Role::Radians, word)) m_name.unit = AngleUnit::Radians;
    if (means(Role::Dms, word)) m_isDms = true;
    take(Role::Gon, m_hasGon);
    take(Role::Grad, m_name.isGrad);
    take(Role::Degrees, m_hasDegrees);
    take(Role::DegreePart, m_hasDegrees);
    take(Role::Radians, m_hasRadians);
    take(Role::Dms, m_isDms);
    take(Role::MinutePart, m_hasMinutes);
    take(Role::SecondPart, m_hasSeconds);
    take(Role::GonMinutePart, m_hasGonMinutes);
    take(Role::GonSecondPart, m_hasGonSeconds);
    return isTaken;
  }

  static bool isAngle(const TableColumn& column) { return column.field && alidade::isAngle(*column.field); }

  void takeParts() {
    const bool hasMinutes = m_hasMinutes || m_hasGonMinutes, hasSeconds = m_hasSeconds || m_hasGonSeconds;
    if (m_isDms || (hasMinutes && hasSeconds)) {
      m_name.unit = AngleUnit::Dms;
      m_isStrange = m_isStrange || m_hasGonMinutes || m_hasGonSeconds;
      return;
    }
    const bool isWhole = (m_hasDegrees || m_hasGon || m_name.isGrad) && (hasMinutes || hasSeconds);
    if (isWhole) {  // degrees and minutes in one number
      m_name.unit = AngleUnit::Unstated;
      m_name.isGrad = false;
      return;
    }
    m_name.isPart = hasMinutes || hasSeconds || m_hasDegrees || m_hasGon || m_name.isGrad;
    m_name.isCentesimal = m_hasGonMinutes || m_hasGonSeconds;
    if (hasMinutes) m_name.part = AnglePart::Minutes;
    if (hasSeconds) m_name.part = AnglePart::Seconds;
    if (hasMinutes || hasSeconds) {
      m_name.unit = AngleUnit::Unstated;
      m_name.isGrad = false;
    }
    if (m_name.column) m_name.column->part = m_name.part;
  }

  std::vector<std::string> m_words;
  ColumnName m_name;
  bool m_isZenith = false, m_isElevation = false, m_isVertical = false, m_isHorizontal = false;
  bool m_isOfCircle = false, m_isCircleNamed = false, m_isFaceless = true, m_counts = false,
       m_isStrange = false;
  bool m_hasGon = false, m_hasDegrees = false, m_hasRadians = false, m_isDms = false;
  bool m_hasMinutes = false, m_hasSeconds = false, m_hasGonMinutes = false, m_hasGonSeconds = false;
};

}  // namespace

ColumnName columnName(const std::string& text) {
  if (const RowField* field = rowFieldNamed(lowerCase(text)); field && isFreeText(*field)) {
    ColumnName own;
    own.column = TableColumn{field};
    own.isUnderstood = true;
    return own;
  }
  const std::vector<std::string> words = headingWords(text);
  if (auto tilt = tiltName(words)) return *std::move(tilt);
  return NameReader(words).read();
}

bool areColumnNames(const std::vector<std::string>& cells) {
  bool isAnyKnown = false;
  for (const std::string& cell : cells) {
    if (parseNumber(cell) || parseAngle(cell)) return false;
    isAnyKnown = isAnyKnown || columnName(cell).column.has_value();
  }
  return isAnyKnown;
}

bool nameCircles(const std::vector<std::string>& cells) {
  bool isHorizontal = false, isVertical = false;
  for (const std::string& cell : cells) {
    const auto column = columnName(cell).column;
    isHorizontal = isHorizontal || (column && column->isOf(&Reading::horizontal));
    isVertical = isVertical || (column && column->isOf(&Reading::vertical));
  }
  return isHorizontal && isVertical;
}

}  // namespace alidade
