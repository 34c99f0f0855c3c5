#include "core/certificate/element.h"

#include <openssl/evp.h>

#include <pugixml.hpp>

#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

std::string qualified(const char* name) {
  return std::string_view(name).starts_with("si:") ? name : std::string("dcc:") + name;
}

std::string base64(std::string_view bytes) {
  // Four characters for every three bytes, and OpenSSL's terminating zero.
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  std::size_t length = 0;
  constexpr std::size_t piece = std::size_t{3} << 24U;  // fits into an int; a multiple of 3 needs no padding
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, piece);
    length += static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data() + length),
                                                       reinterpret_cast<const unsigned char*>(part.data()),
                                                       static_cast<int>(part.size())));
    bytes.remove_prefix(part.size());
  }
  text.resize(length);
  return text;
}

bool isBlankSign(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Writes U+FFFE and U+FFFF as escapes, since XML 1.0 excludes these characters.
std::string withoutNonCharacters(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (character.code == 0xFFFE)
      result += "\\ufffe";
    else if (character.code == 0xFFFF)
      result += "\\uffff";
    else
      result += text.substr(0, character.length);
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace

std::string certificateText(std::string_view text) {
  while (!text.empty() && isBlankSign(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlankSign(text.back())) text.remove_suffix(1);
  return withoutNonCharacters(visibleText(text, "\n"));
}

Element::Element(const pugi::xml_node& node, const std::vector<CertificateLanguage>& languages)
    : m_node(node.internal_object()), m_languages(&languages) {}

Element Element::add(const char* name) const {
  return {pugi::xml_node(m_node).append_child(qualified(name).c_str()), *m_languages};
}

const Element& Element::attribute(const char* name, const std::string& value) const {
  pugi::xml_node(m_node).append_attribute(name).set_value(value.c_str());
  return *this;
}

void Element::value(const char* name, const std::string& text) const {
  pugi::xml_node(add(name).m_node).text().set(certificateText(text).c_str());
}

Element Element::say(const char* name, const Say& text) const {
  const Element element = add(name);
  element.addContent(text);
  return element;
}

Element Element::typed(const char* name, const std::string& text) const {
  const Element element = add(name);
  element.content(text, {});
  return element;
}

void Element::addContent(const Say& text) const {
  for (const CertificateLanguage& language : *m_languages)
    content(language.speak ? language.speak(text) : text(), language.code);
}

void Element::content(const std::string& text, const std::string& language) const {
  const Element element = add("content");
  if (!language.empty()) element.attribute("lang", language);
  pugi::xml_node(element.m_node).text().set(certificateText(text).c_str());
}

void Element::file(const char* name, const std::string& fileName, const std::string& mimeType,
                   std::string_view bytes) const {
  const Element element = add(name);
  element.value("fileName", fileName);
  element.value("mimeType", mimeType);
  pugi::xml_node(element.add("dataBase64").m_node).text().set(base64(bytes).c_str());
}

void Element::identification(const char* issuer, const std::string& value, const Say& what,
                             const char* refType) const {
  const Element own = add("identification");
  if (refType) own.attribute("refType", refType);
  own.value("issuer", issuer);
  own.value("value", value);
  own.say("name", what);
}

}  // namespace alidade
