#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The context in which the lists of translations have the texts of a class, whatever namespace it is in.
#define PHRASE_CONTEXT(context)

namespace alidade {

/// What stands in a phrase in the place of a mark.
class PhraseValue {
 public:
  PhraseValue(std::string text) : m_text(std::move(text)) {}
  PhraseValue(std::string_view text) : m_text(text) {}
  PhraseValue(const char* text) : m_text(text) {}
  template <std::integral Number>
  PhraseValue(Number number) : m_text(std::to_string(number)) {}

  const std::string& text() const { return m_text; }

 private:
  std::string m_text;
};

/// Texts for people. They stand in the sources in English; a program that speaks other languages puts its own
/// text for an English one in its place. Whole phrases with marks, so that another language can order the
/// words as it does; never sentences added up from pieces.
struct Phrase {
  PHRASE_CONTEXT(Phrase)

  /// `english`, or what the interpreter has for it, with "%1" … "%9" replaced by the values in their order.
  /// Marks that have no value, and percent signs before anything else, stay as they are; a value is not
  /// looked through for marks.
  template <class... Values>
  static std::string of(const char* english, const Values&... values) {
    return filled(interpreted(english), {PhraseValue(values)...});
  }

  /// From English, UTF-8, to the language of the thread that asks.
  using Interpreter = std::string (*)(const char* english);
  /// For the whole program, before its first phrase in another language; null: English.
  static void setInterpreter(Interpreter interpreter);

 private:
  static std::string interpreted(const char* english);
  static std::string filled(const std::string& text, const std::vector<PhraseValue>& values);
};

}  // namespace alidade

/// An English text of a table, to be handed to `Phrase::of` later: marks it for the lists of translations.
/// `context` is "Phrase".
#define PHRASE_LATER(context, english) english
