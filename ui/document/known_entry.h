#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/problem.h"
#include "core/effects/catalogue.h"
#include "core/session/session.h"

namespace alidade::ui {

// Access to the known sizes of a session: by entry in its two lists, and by catalogued number.

enum class KnownOwner { Instrument, Device };

/// The owner of a list and an index into the list; the index may be beyond the end.
struct KnownRef {
  KnownOwner owner = KnownOwner::Instrument;
  std::size_t index = 0;

  bool operator==(const KnownRef&) const = default;
};

/// Device for effects of the guideway itself; instrument for all others, such as a drift of the set-up.
KnownOwner ownerOf(const Effect& effect);

const std::vector<KnownSize>& knownBy(const Session& session, KnownOwner owner);
std::vector<KnownSize>& knownBy(Session& session, KnownOwner owner);

/// Null if the session has no such entry.
const KnownSize* knownSize(const Session& session, const KnownRef& ref);

/// The place {.field = "instrument.known[2]"}; for the member "sigma", ".sigma" is appended.
Place placeOf(const KnownRef& ref, std::string_view member = {});

struct KnownPlace {
  KnownRef ref;
  std::string member;  ///< "value", "sigma", …; empty: the entry as a whole
};

/// The reverse of `placeOf`; absent if `place` is not an entry of the known sizes.
std::optional<KnownPlace> knownAt(const Place& place);

/// A catalogued number, with or without a known size, or an entry for a number unknown to the catalogue.
struct KnownRow {
  const Effect* effect = nullptr;              ///< null: number unknown to the catalogue
  const EffectParameter* parameter = nullptr;  ///< null if `effect` is null
  std::optional<KnownRef> entry = {};          ///< absent: no known size, so the default applies
  bool isFurther = false;                      ///< true: an earlier row is for the same number

  bool operator==(const KnownRow&) const = default;
};

/// A row for every catalogued number that can have a known size, with the number's first entry if any. Rows
/// for further entries of the number follow. Entries of unknown numbers come last.
std::vector<KnownRow> knownRows(const Session& session);

}  // namespace alidade::ui
