#include "core/exchange/recording.h"

#include <algorithm>
#include <utility>

#include "core/base/angle.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

bool isPlainNumber(const std::string& text) {
  const std::size_t start = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const auto digits = std::count_if(text.begin(), text.end(), isDigit);
  const auto signs = std::count_if(text.begin(), text.end(), [](char c) { return c == '.' || c == ','; });
  return digits > 0 && signs <= 1 && start + static_cast<std::size_t>(digits + signs) == text.size();
}

/// Converts 341.5224 to 341 52 24.
std::string inParts(const std::string& number) {
  const std::size_t sign = std::min(number.find_first_of(".,"), number.size());
  std::string decimals = sign < number.size() ? number.substr(sign + 1) : std::string();
  decimals.resize(std::max<std::size_t>(decimals.size(), 4), '0');
  std::string parts = number.substr(0, sign) + " " + decimals.substr(0, 2) + " " + decimals.substr(2, 2);
  if (decimals.size() > 4) parts += "." + decimals.substr(4);
  return parts;
}

std::size_t indexOf(const RowField& field) {
  return static_cast<std::size_t>(&field - rowFields.data());
}

}  // namespace

std::string LineProblem::text() const {
  const std::string sentence = column > 0 ? Phrase::of("line %1, column %2: %3", line, column, what)
                                          : Phrase::of("line %1: %2", line, what);
  return file.empty() ? sentence : listed({quotation(file), sentence});
}

void RecordedSighting::enter(const RowField& field, std::string text, std::size_t column) {
  row.*field.text = std::move(text);
  columns[indexOf(field)] = column;
}

std::size_t RecordedSighting::columnOf(const RowField& field) const {
  return columns[indexOf(field)];
}

std::size_t Recording::stationNamed(const std::string& name) {
  if (name.empty()) return 0;
  const auto [known, isNew] = stationIndices.try_emplace(name, stations.size());
  if (isNew) stations.push_back(name);
  return known->second;
}

std::string withUnit(const std::string& text, AngleUnit unit) {
  const std::string plain = plainSigns(text);
  if (unit == AngleUnit::Unstated || !isPlainNumber(plain)) return text;
  if (unit == AngleUnit::Degrees) return plain + "°";
  if (unit == AngleUnit::Gon) return plain + "gon";
  if (unit == AngleUnit::Radians) {
    constexpr int decimals = 10;  // 10⁻¹⁰°, less than a millionth of an arcsecond
    const Result<double> radians = parseNumber(plain);
    return radians ? fixedText(Angle::fromRadians(*radians).degrees(), decimals) + "°" : text;
  }
  return inParts(plain);
}

}  // namespace alidade
