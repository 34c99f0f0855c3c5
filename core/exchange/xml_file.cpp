#include "core/exchange/xml_file.h"

#include <algorithm>
#include <pugixml.hpp>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"
#include "core/session/face.h"

namespace alidade {

namespace {

/// Most signs < and =; the element or attribute at each takes up to 64 bytes of memory.
constexpr std::size_t mostMarks = 8'000'000;

bool hasTooManyMarks(std::string_view text) {
  const auto marks = std::ranges::count_if(text, [](char c) { return c == '<' || c == '='; });
  return static_cast<std::size_t>(marks) > mostMarks;
}

/// The starts of lines, which end with LF, CR LF or CR as in `TextLines`.
std::vector<std::size_t> lineStartsOf(std::string_view text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t at = 0; (at = text.find_first_of("\r\n", at)) != std::string_view::npos;) {
    at += text.substr(at, 2) == "\r\n" ? 2 : 1;
    if (at < text.size()) starts.push_back(at);
  }
  return starts;
}

/// The digits with the decimal point after the first `whole` digits; zeros fill missing places.
std::string withPointAt(const std::string& digits, std::ptrdiff_t whole) {
  const auto size = static_cast<std::ptrdiff_t>(digits.size());
  if (whole <= 0) return "0." + std::string(static_cast<std::size_t>(-whole), '0') + digits;
  if (whole >= size) return digits + std::string(static_cast<std::size_t>(whole - size), '0');
  return digits.substr(0, static_cast<std::size_t>(whole)) + "." +
         digits.substr(static_cast<std::size_t>(whole));
}

/// Carries sixty seconds and minutes: `107 59 60.0` becomes `108 00 00.0`.
std::string withSixtiesCarried(const std::string& parts) {
  const std::size_t first = parts.find(' '), second = parts.find(' ', first + 1);
  int degrees = *parseWhole(parts.substr(0, first));
  int minutes = *parseWhole(parts.substr(first + 1, second - first - 1));
  std::string seconds = parts.substr(second + 1);
  if (seconds.starts_with("60")) {
    seconds.replace(0, 2, "00");
    ++minutes;
  }
  if (minutes == 60) {
    minutes = 0;
    ++degrees;
  }
  const std::string two = minutes < 10 ? "0" : "";
  return std::to_string(degrees) + " " + two + std::to_string(minutes) + " " + seconds;
}

/// The text in a notation of `parseAngle`; absent if it is not a circle reading.
std::optional<std::string> xmlCircleText(const std::string& number, AngleUnit unit) {
  const auto plain = plainXmlNumber(number);
  if (!plain || plain->starts_with('-')) return std::nullopt;
  constexpr std::size_t longestWhole = 4;
  if (std::min(plain->find('.'), plain->size()) > longestWhole) return std::nullopt;
  const std::string text = withUnit(*plain, unit);
  return unit == AngleUnit::Dms ? withSixtiesCarried(text) : text;
}

constexpr double fullXmlCircle = 360, xmlRounding = 1e-9;

}  // namespace

XmlFile::XmlFile(std::string_view file)
    : m_document(std::make_unique<pugi::xml_document>()), m_lineStarts(lineStartsOf(untilEndOfFile(file))) {
  const std::string_view text = untilEndOfFile(file);
  if (text.empty()) return;
  if (hasTooManyMarks(text)) {
    m_problem = {1, 0,
                 Phrase::of("has more than %1 elements and attributes: export the job in parts",
                            limits::asCount(mostMarks))};
    return;
  }
  constexpr unsigned options = pugi::parse_minimal | pugi::parse_escapes | pugi::parse_cdata |
                               pugi::parse_wconv_attribute | pugi::parse_embed_pcdata;
  const pugi::xml_parse_result read =
      m_document->load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
  if (read) return;
  const std::size_t offset =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(read.offset, 0)), text.size() - 1);
  m_problem = {lineAt(offset), 0,
               Phrase::of("the elements of the XML file are broken off or do not close: export it again")};
}

XmlFile::~XmlFile() = default;

pugi::xml_node XmlFile::root() const {
  return m_document->document_element();
}

std::size_t XmlFile::lineAt(std::size_t offset) const {
  const auto next = std::ranges::upper_bound(m_lineStarts, offset);
  return std::max<std::size_t>(static_cast<std::size_t>(next - m_lineStarts.begin()), 1);
}

std::size_t XmlFile::lineOf(const pugi::xml_node& element) const {
  return lineAt(static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0)));
}

std::string_view xmlName(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  return name.substr(name.find(':') + 1);
}

pugi::xml_node xmlChild(const pugi::xml_node& element, std::string_view name) {
  return element.find_child([name](const pugi::xml_node& child) { return xmlName(child) == name; });
}

std::string xmlText(const pugi::xml_node& element, std::string_view name) {
  return trimmed(xmlChild(element, name).text().get());
}

std::string xmlValue(const pugi::xml_node& element, const char* name) {
  return trimmed(element.attribute(name).value());
}

std::optional<std::string> plainXmlNumber(std::string_view text) {
  std::string sign;
  if (text.starts_with('+') || text.starts_with('-')) {
    if (text[0] == '-') sign = "-";
    text.remove_prefix(1);
  }
  constexpr std::size_t mostDigits = 40;
  constexpr int farthest = 20;
  const std::size_t mark = text.find_first_of("eE");
  int exponent = 0;
  if (mark != std::string_view::npos) {
    const Result<int> stated = parseWhole(text.substr(mark + 1));
    if (!stated || *stated < -farthest || *stated > farthest) return std::nullopt;
    exponent = *stated;
  }
  const std::string_view number = text.substr(0, mark);
  const std::size_t point = std::min(number.find('.'), number.size());
  std::string digits(number.substr(0, point));
  if (point < number.size()) digits += number.substr(point + 1);
  if (digits.empty() || digits.size() > mostDigits || !std::ranges::all_of(digits, isDigit))
    return std::nullopt;
  if (mark == std::string_view::npos && point > 0 && point + 1 != number.size())
    return sign + std::string(number);
  return sign + withPointAt(digits, static_cast<std::ptrdiff_t>(point) + exponent);
}

std::string dateOfTime(std::string_view time) {
  constexpr std::string_view pattern = "0000-00-00";
  if (time.size() < pattern.size()) return {};
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] == '0' ? !isDigit(time[i]) : time[i] != pattern[i]) return {};
  return std::string(time.substr(0, pattern.size()));
}

std::optional<std::string> enterCircles(const XmlCircles& circles, RecordedSighting& sighting) {
  double vertical = 0;
  for (const auto& [field, number] : {std::pair(&Reading::horizontal, &circles.horizontal),
                                      std::pair(&Reading::vertical, &circles.vertical)}) {
    const auto text = xmlCircleText(*number, circles.unit);
    const Result<Angle> angle = text ? parseAngle(*text) : Result<Angle>(Problem{});
    if (!angle || angle->degrees() > fullXmlCircle + xmlRounding)
      return Phrase::of(
          "%1 is no reading of a circle in the unit of the file: export the file again, or "
          "delete the observation",
          quotation(*number));
    const bool isFull = angle->degrees() >= fullXmlCircle - xmlRounding / 1000;
    sighting.enter(rowField(field), isFull ? "0°" : *text, 0);
    vertical = angle->degrees();
  }
  const bool isSecondFace = vertical > fullXmlCircle / 2;
  if (!circles.face.empty() && (circles.face == "2") != isSecondFace && vertical > 0)
    return Phrase::of(
        "is of %1, yet its vertical reading %2 is of the other face, so the readings were "
        "reduced: export the circles as they were read",
        faceName(circles.face == "2" ? 2 : 1), quotation(circles.vertical));
  sighting.row.face = circles.face;
  return std::nullopt;
}

}  // namespace alidade
