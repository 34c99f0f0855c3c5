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

// Repeats the fit of a session for drawn values, in three ways that agree.

/// The constant part of all draws. Must outlive every refit.
struct RefitTask {
  const Measurement& fitted;  ///< as read
  const SessionFit& fit;      ///< of `fitted`
  const DrawPlan& plan;

  std::size_t centres() const { return 2 * fitted.arcs.size(); }
};

/// Value of a centre whose fit did not converge or is undetermined.
inline constexpr double missingCentre = std::numeric_limits<double>::quiet_NaN();

/// A refit for one thread: it owns its working memory.
class Refit {
 public:
  virtual ~Refit() = default;

  /// Δx and Δy of each arc, draw after draw, mm; `missingCentre` for an arc without a fit.
  virtual void refit(std::span<const Draw> draws, std::span<double> centres) = 0;
};

/// Can each arc be fitted alone? True if the model has no effects and free radii, no slider was read, no axis
/// repeated, and the kernels are exact.
bool haveNothingInCommon(const Measurement& fitted);

/// Uses the fits of the session itself. Slow, and valid for any draw.
std::unique_ptr<Refit> generalRefit(const RefitTask& task);

/// Uses `fitArcsFast`, with a lane for each draw, if the arcs are independent (`haveNothingInCommon`) and
/// every visit of an arc has equally many rows. Otherwise null. Draws that are refused go to `generalRefit`.
std::unique_ptr<Refit> arcsRefit(const RefitTask& task);

/// The forward model to second order about the fit (expanded_refit.cpp). Null if there are so many readings
/// that their derivatives would fill the memory.
class ExpandedModel;
std::shared_ptr<const ExpandedModel> expandedModel(const RefitTask& task);
std::unique_ptr<Refit> expandedRefit(const RefitTask& task, std::shared_ptr<const ExpandedModel> model);

}  // namespace alidade
