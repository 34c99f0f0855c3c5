#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/effects/catalogue.h"
#include "core/session/own_effects.h"

namespace alidade {

/// The columns of one effect. A bent effect also has second derivatives: weights (x, y, ½x², xy, ½y²).
struct EffectColumns {
  const Effect* effect;
  std::size_t first, count;
  bool isPattern = false;
  int order = 0;                  ///< for a pattern: periods in a turn; 0 if it is not harmonic
  const OwnEntry* own = nullptr;  ///< an effect of the user's own
};

/// The columns that sessions have in common: of the catalogue's effects, of user's own effects that several
/// sessions have, then of the patterns (`session_patterns.h`). A weight of 1 is a plausible size.
class SharedColumns {
 public:
  /// `own` has the user's effects of each session; null: none. Effects with equal id, formula and plausible
  /// sizes are the same. Own effects get at most 24 columns in all, the most frequent effects first.
  explicit SharedColumns(const std::vector<std::shared_ptr<const OwnEffects>>& own = {});

  const std::vector<EffectColumns>& all() const { return m_all; }
  std::span<const EffectColumns> effects() const { return {m_all.data(), m_effects}; }
  std::size_t count() const { return m_starts.size(); }
  /// Number of columns of effects.
  std::size_t effectCount() const { return m_effectColumns; }

  /// The columns of an effect in a session with these own effects; null if there are none.
  const EffectColumns* of(std::string_view id, const OwnEffects* own) const;

  /// Returns the index of the product of two columns in `SessionEvidence::normal`. Each column has products
  /// with the effects' columns up to itself. A pattern's column also has products with the columns of its own
  /// pattern up to itself. Products of two different patterns are not stored.
  std::size_t productAt(std::size_t a, std::size_t b) const;

 private:
  struct Start {
    std::size_t products, first;  ///< first stored product; first column of its effect or pattern
  };

  std::vector<EffectColumns> m_all;
  std::size_t m_effects = 0, m_effectColumns = 0;
  std::vector<Start> m_starts;  ///< start of each column
  std::vector<std::shared_ptr<const OwnEffects>> m_kept;

  void addOwn(const std::vector<std::shared_ptr<const OwnEffects>>& own);
  void add(EffectColumns columns);
};

}  // namespace alidade
