#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/recording.h"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace alidade {

/// The elements of an XML text, which knows their lines. Entities are not expanded and nothing outside the
/// text is read. A text with more marks than are read, or whose elements do not close, has a problem; the
/// elements up to it are there.
class XmlFile {
 public:
  /// UTF-8, whatever its declaration says; kept by the caller.
  explicit XmlFile(std::string_view text);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  pugi::xml_node root() const;  ///< the outermost element; null where there is none
  std::size_t lineOf(const pugi::xml_node& element) const;  ///< from 1
  const std::optional<LineProblem>& problem() const { return m_problem; }

 private:
  std::size_t lineAt(std::size_t offset) const;

  std::unique_ptr<pugi::xml_document> m_document;
  std::vector<std::size_t> m_lineStarts;  ///< bytes from the beginning of the text
  std::optional<LineProblem> m_problem;
};

/// An element's name without its prefix.
std::string_view xmlName(const pugi::xml_node& element);

/// The first element of that name below; null where there is none.
pugi::xml_node xmlChild(const pugi::xml_node& element, std::string_view name);

/// The text of the first element of that name below, without blanks around.
std::string xmlText(const pugi::xml_node& element, std::string_view name);

/// The value of an attribute, without blanks around.
std::string xmlValue(const pugi::xml_node& element, const char* name);

/// A number of XML Schema (double) in plain digits, every one kept: `4.5e-05` as `0.000045`. Absent where it
/// is none, or has more digits than any reading.
std::optional<std::string> plainXmlNumber(std::string_view text);

/// Year-month-day of a time such as 2025-04-22T15:10:05; empty where it is none.
std::string dateOfTime(std::string_view time);

/// The circles of a sighting as a file in XML has them, in a notation of `parseAngle`. Full circles are
/// zeros. Why they cannot be used: one is missing, is no angle, lies beyond the circle, or contradicts the
/// face.
struct XmlCircles {
  std::string horizontal, vertical;  ///< of a zenith circle
  AngleUnit unit = AngleUnit::Degrees;
  std::string face = {};  ///< "1", "2", or empty where the file does not say
};
std::optional<std::string> enterCircles(const XmlCircles& circles, RecordedSighting& sighting);

}  // namespace alidade
