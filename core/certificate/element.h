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

/// A text of the program's own, as `Phrase::of` makes it where it is called.
using Say = std::function<std::string()>;

/// A language that a certificate speaks.
struct CertificateLanguage {
  std::string code;                                        ///< ISO 639-1: "en"
  std::function<std::string(const Say&)> speak = nullptr;  ///< calls it in that language; empty: English
};

/// Somebody's text as a certificate holds it: without blanks at its ends, and what XML cannot hold, what acts
/// on a terminal and what turns or hides text as its escape (`visibleText`).
std::string certificateText(std::string_view text);

/// An element of the certificate. Names are those of the schema, `dcc:` before them unless they say `si:`.
class Element {
 public:
  /// `languages`: at least one; must outlive it.
  Element(const pugi::xml_node& node, const std::vector<CertificateLanguage>& languages);

  Element add(const char* name) const;
  const Element& attribute(const char* name, const std::string& value) const;
  /// An element with a text and nothing else.
  void value(const char* name, const std::string& text) const;
  /// Of `textType` or `richContentType`: one `content` for each language.
  Element say(const char* name, const Say& text) const;
  /// The same of what somebody typed, in whatever language.
  Element typed(const char* name, const std::string& text) const;
  /// Further contents of such an element.
  void addContent(const Say& text) const;
  /// Of `byteDataType`: the bytes as base64.
  void file(const char* name, const std::string& fileName, const std::string& mimeType,
            std::string_view bytes) const;
  /// An `identification`: its `value` by that `issuer` and what it is.
  void identification(const char* issuer, const std::string& value, const Say& what,
                      const char* refType = nullptr) const;

 private:
  void content(const std::string& text, const std::string& language) const;

  pugi::xml_node_struct* m_node;
  const std::vector<CertificateLanguage>* m_languages;
};

}  // namespace alidade
