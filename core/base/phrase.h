#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The context of a class's texts in the translation files, independent of its namespace.
#define PHRASE_CONTEXT(context)

namespace alidade {

/// The value that replaces a mark in a phrase.
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

/// Texts for people. The sources contain them in English; a program in another language replaces the English
/// text. Each text is a whole phrase with marks, in which a translation can reorder the words. No sentence is
/// assembled from pieces.
struct Phrase {
  PHRASE_CONTEXT(Phrase)

  /// `english`, or the interpreter's text for it, with "%1" … "%9" replaced by the values in order. Marks
  /// without a value, and other percent signs, stay unchanged; values are not searched for marks.
  template <class... Values>
  static std::string of(const char* english, const Values&... values) {
    return filled(interpreted(english), {PhraseValue(values)...});
  }

  /// Translates from English, UTF-8, to the language of the calling thread.
  using Interpreter = std::string (*)(const char* english);
  /// Sets the interpreter of the whole program, before the first phrase in another language. Null: English.
  static void setInterpreter(Interpreter interpreter);

 private:
  static std::string interpreted(const char* english);
  static std::string filled(const std::string& text, const std::vector<PhraseValue>& values);
};

}  // namespace alidade

/// Marks an English text in a table for the translation files. The text is passed to `Phrase::of` later.
/// `context` is "Phrase".
#define PHRASE_LATER(context, english) english
