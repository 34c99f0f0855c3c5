#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/place.h"
#include "core/effects/catalogue.h"
#include "core/session/session.h"

namespace alidade::ui {

// What a session says is known of the numbers of the catalogue: entry by entry in its two lists, and number
// by number.

enum class KnownOwner { Instrument, Device };

/// One entry of a list; there is none where the list is shorter.
struct KnownRef {
  KnownOwner owner = KnownOwner::Instrument;
  std::size_t index = 0;

  bool operator==(const KnownRef&) const = default;
};

/// The device's where the effect is the guideway's own, else the instrument's: a drift is of how it was set
/// up.
KnownOwner ownerOf(const Effect& effect);

const std::vector<KnownSize>& knownBy(const Session& session, KnownOwner owner);
std::vector<KnownSize>& knownBy(Session& session, KnownOwner owner);

/// Null where the session has no such entry.
const KnownSize* knownSize(const Session& session, const KnownRef& ref);

/// {.field = "instrument.known[2]"}, with ".sigma" behind it where `member` is "sigma".
Place placeOf(const KnownRef& ref, std::string_view member = {});

struct KnownPlace {
  KnownRef ref;
  std::string member;  ///< "value", "sigma", …; empty: the entry as a whole
};

/// The reverse; absent where `place` is of no such entry.
std::optional<KnownPlace> knownAt(const Place& place);

/// A number of the catalogue with what is known of it; or an entry that is of no number.
struct KnownRow {
  const Effect* effect = nullptr;              ///< null: of no number of the catalogue
  const EffectParameter* parameter = nullptr;  ///< null likewise
  std::optional<KnownRef> entry = {};          ///< absent: nothing is known, and the default is taken
  bool isFurther = false;                      ///< an entry above is of the same number

  bool operator==(const KnownRow&) const = default;
};

/// A row for every number of the catalogue that can be known by a size, with its first entry in whichever
/// list, and below it one for each further entry; at the end the entries that are of no number.
std::vector<KnownRow> knownRows(const Session& session);

}  // namespace alidade::ui
