#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/session/entry.h"
#include "core/session/session.h"
#include "core/session/value_text.h"

namespace alidade {

// The single texts of a session, defined once for all uses: the session file, the checks of entries, the
// forms of the window, undo, the journal and the comparison of sessions. A new text needs a member in
// session.h, a line in session_fields.cpp, and one in the schema of the session file.

/// The rule for a text with a fixed set of values or a fixed form. Returns the reason why a text is invalid.
using WordRule = std::optional<Problem> (*)(const std::string& text);

/// One of the words of a field, with its label in the forms. An empty word means that nothing is stated.
struct WordChoice {
  const char *word, *caption;
};

/// The English texts are for the translation contexts "Field" (`noun`) and "Forms" (all others); null: none.
struct SessionField {
  std::string_view key;  ///< in the session file: "geometry.distance_mm"
  const char* noun;      ///< name in undo texts, in the journal and in lists of missing entries
  std::variant<FreeText, NumberRule, WordRule> rule = FreeText();
  const char* remedy = nullptr;     ///< what to do if a file lacks the key, for `Phrase::of`; null: optional
  const char* caption = nullptr;    ///< label in a form, with a mnemonic
  const char* unit = nullptr;       ///< shown after the entry
  const char* whenEmpty = nullptr;  ///< what an empty entry means
  const char* help = nullptr;       ///< tool tip
  std::span<const WordChoice> choices = {};  ///< shown as a list instead of a line to type in
  bool fillsRow = false;                     ///< long texts have a whole row of a form
  bool isOfMeasurement = true;      ///< false: says who, where and for whom, and never enters a result
  bool isOfOneMeasurement = false;  ///< whether the next session begins without it (`nextSession`)
  bool isWantedOnReport = false;    ///< wanted by ISO/IEC 17025:2017, 7.8.2, 7.8.4; the decision rule: 7.8.6

  const std::string& (*get)(const Session& session) = nullptr;
  std::string& (*at)(Session& session) = nullptr;

  /// The object of the session file that contains the field, "geometry"; empty: the session itself.
  std::string_view part() const { return key.substr(0, key.find('.') == key.npos ? 0 : key.find('.')); }
  std::string_view name() const { return key.substr(key.find('.') + 1); }  ///< key within `part()`
  ValueKind kind() const {
    return std::holds_alternative<NumberRule>(rule) ? ValueKind::Number : ValueKind::Text;
  }
};

/// All fields in the order of the session file.
std::span<const SessionField> sessionFields();

/// The field with this key; null if there is none.
const SessionField* sessionFieldNamed(std::string_view key);

/// Do two sessions contain the same measurement? The journal, and entries that only say who, where and for
/// whom, may differ.
bool isSameMeasurement(const Session& a, const Session& b);

/// The number of a text with the unit of its field, such as "400 mm"; other texts as typed.
std::string withoutUnit(const SessionField& field, const std::string& typed);

/// Returns the reason why `text` is invalid in the field.
std::optional<Problem> entryProblem(const SessionField& field, const std::string& text);

// The fields of each form of the window, in order.
extern const std::span<const std::string_view> measurementForm, instrumentForm, laboratoryForm, sessionForm;

}  // namespace alidade
