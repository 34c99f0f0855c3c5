#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pugi {
class xml_node;
struct xml_node_struct;
}  // namespace pugi

namespace alidade {

/// A text of the program, which `Phrase::of` makes in the language of the call.
using Say = std::function<std::string()>;

/// A language of a certificate.
struct CertificateLanguage {
  std::string code;                                        ///< ISO 639-1: "en"
  std::function<std::string(const Say&)> speak = nullptr;  ///< calls its argument in that language; empty:
                                                           ///< English
};

/// User text for a certificate, without blanks at its ends. Characters that XML cannot hold, or that control
/// a terminal, reverse text or hide it, are written as escapes (`visibleText`).
std::string certificateText(std::string_view text);

/// An element of the certificate. Names are those of the schema. A name without the prefix `si:` gets the
/// prefix `dcc:`.
class Element {
 public:
  /// `languages`: at least one; must outlive the element.
  Element(const pugi::xml_node& node, const std::vector<CertificateLanguage>& languages);

  Element add(const char* name) const;
  const Element& attribute(const char* name, const std::string& value) const;
  /// Adds an element that holds only a text.
  void value(const char* name, const std::string& text) const;
  /// Adds an element of `textType` or `richContentType`, with one `content` for each language.
  Element say(const char* name, const Say& text) const;
  /// Adds an element of `textType` with one `content`: user text in an unknown language.
  Element typed(const char* name, const std::string& text) const;
  /// Adds to this element a further `content` for each language.
  void addContent(const Say& text) const;
  /// Adds an element of `byteDataType`: the bytes as base64.
  void file(const char* name, const std::string& fileName, const std::string& mimeType,
            std::string_view bytes) const;
  /// Adds an `identification`: its `value`, `issuer` and description.
  void identification(const char* issuer, const std::string& value, const Say& what,
                      const char* refType = nullptr) const;

 private:
  void content(const std::string& text, const std::string& language) const;

  pugi::xml_node_struct* m_node;
  const std::vector<CertificateLanguage>* m_languages;
};

}  // namespace alidade
