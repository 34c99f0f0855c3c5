#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/adjustment/monte_carlo/draw.h"
#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// The fit of a session repeated for what was drawn, in three ways that agree.

/// What stays the same from draw to draw. Must outlive every refit.
struct RefitTask {
  const Measurement& fitted;  ///< what was read
  const SessionFit& fit;      ///< of it
  const DrawPlan& plan;

  std::size_t centres() const { return 2 * fitted.arcs.size(); }
};

/// Of a centre whose fit did not settle, or which the readings do not fix.
inline constexpr double missingCentre = std::numeric_limits<double>::quiet_NaN();

/// For one thread: holds the places that it works in.
class Refit {
 public:
  virtual ~Refit() = default;

  /// Δx and Δy of each arc, draw after draw, mm; `missingCentre` in place of what was not found.
  virtual void refit(std::span<const Draw> draws, std::span<double> centres) = 0;
};

/// Each arc may be fitted by itself: one instrument without effects, free radii, no slider, no axis again.
bool haveNothingInCommon(const Measurement& fitted);

/// By the fits that the session itself goes through. Slow, and right whatever was drawn.
std::unique_ptr<Refit> generalRefit(const RefitTask& task);

/// By `fitArcsFast`, a lane for each draw, where the arcs have nothing in common (`haveNothingInCommon`) and
/// every visit of an arc as many rows. Null elsewhere. What that refuses is
/// fitted in general.
std::unique_ptr<Refit> arcsRefit(const RefitTask& task);

/// The forward model to second order about the fit (expanded_refit.cpp). Null where there are so many
/// readings that their derivatives would fill the memory.
class ExpandedModel;
std::shared_ptr<const ExpandedModel> expandedModel(const RefitTask& task);
std::unique_ptr<Refit> expandedRefit(const RefitTask& task, std::shared_ptr<const ExpandedModel> model);

}  // namespace alidade
