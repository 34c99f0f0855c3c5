#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/session/instrument_record.h"
#include "core/session/own_effect.h"
#include "core/session/sighting_protocol.h"
#include "ui/document/known_entry.h"

namespace alidade {
struct StatedNoise;
}

namespace alidade::ui {

class SessionDocument;

/// Adds the effect `id` to the estimated effects, or removes it; does nothing if the model agrees already.
/// Keeps all other effects, including unknown ones.
void setEffect(SessionDocument& document, const std::string& id, bool isEstimated);

/// Adds the effects of `ids` that are not estimated yet, as one undo step.
void addEffects(SessionDocument& document, const std::vector<std::string>& ids);

/// Puts a user's own effect into the session, replacing one with the same id.
void keepOwnEffect(SessionDocument& document, const OwnEffect& effect);

/// Sets the field at `place` to `typed`: a day in the session's form (`completedDay`), a number without its
/// unit (`withoutUnit`). Does nothing if the field already has this text.
void changeField(SessionDocument& document, const Place& place, const std::string& typed);

/// Sets the σ of both circles as one undo step.
void stateNoise(SessionDocument& document, const StatedNoise& noise);

/// An editable text of a known size.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< name of the text in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Sets one text of a known size. In a row without an entry, the first text creates an entry in the list of
/// instrument or device; removing the last text removes the entry. Adds no undo step if nothing changes.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

/// Sets the protocol that the user chose and adds the positions that it needs, as one undo step. If
/// `protocol` is absent, removes the protocol. Does nothing if the session already has this protocol.
void followProtocol(SessionDocument& document, std::optional<SightingProtocol> protocol);

/// Copies a record into the session (`takeRecord`) as one undo step; adds no step if nothing changes. `file`:
/// the record's name without folder. Returns a problem if the record belongs to another instrument.
std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file);

}  // namespace alidade::ui
