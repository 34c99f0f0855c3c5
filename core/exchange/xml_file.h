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

/// The elements of an XML text with their line numbers. Only predefined entities are expanded, and no other
/// file is read. A text above the limit of marks has a problem and no elements. If an element is not closed,
/// there is a problem, and the elements before the fault are available.
class XmlFile {
 public:
  /// `text` is UTF-8, whatever its declaration states; owned by the caller.
  explicit XmlFile(std::string_view text);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  pugi::xml_node root() const;                              ///< the outermost element; null if there is none
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

/// The first child element of that name; null if there is none.
pugi::xml_node xmlChild(const pugi::xml_node& element, std::string_view name);

/// The text of the first child element of that name, without surrounding blanks.
std::string xmlText(const pugi::xml_node& element, std::string_view name);

/// The value of an attribute, without surrounding blanks.
std::string xmlValue(const pugi::xml_node& element, const char* name);

/// A number of XML Schema (double) in plain digits, without rounding: `4.5e-05` becomes `0.000045`.
/// Absent if it is not a number, or has more digits than any reading.
std::optional<std::string> plainXmlNumber(std::string_view text);

/// Year-month-day of a time such as 2025-04-22T15:10:05; empty for other texts.
std::string dateOfTime(std::string_view time);

/// The circles of a sighting in an XML file, in a notation of `parseAngle`.
struct XmlCircles {
  std::string horizontal, vertical;  ///< readings, the vertical one of a zenith circle
  AngleUnit unit = AngleUnit::Degrees;
  std::string face = {};  ///< "1", "2", or empty if the file does not state it
};
/// Enters the circles in `sighting`, full circles as zeros. Absent if both were entered; otherwise the reason
/// why not: one is missing, is not an angle, lies beyond the circle, or contradicts the face.
std::optional<std::string> enterCircles(const XmlCircles& circles, RecordedSighting& sighting);

}  // namespace alidade
