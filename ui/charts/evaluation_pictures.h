#pragma once

#include <memory>
#include <stop_token>

#include "core/evaluation/evaluation.h"

namespace alidade::ui {
struct ArcPicture;
struct ResidualPicture;
}  // namespace alidade::ui

namespace alidade {

/// Drawn on the thread of the fit, so that the window only paints.
struct EvaluationPictures {
  std::shared_ptr<const ui::ArcPicture> arcs;
  std::shared_ptr<const ui::ResidualPicture> residuals;
};

}  // namespace alidade

namespace alidade::ui {

/// The evaluation with its pictures; without them if asked to stop.
Evaluation drawn(Evaluation evaluation, const std::stop_token& stop = {});

/// The picture drawn along with the evaluation, or else a new one.
std::shared_ptr<const ArcPicture> arcPictureOf(const Evaluation& evaluation);
std::shared_ptr<const ResidualPicture> residualPictureOf(const Evaluation& evaluation);

}  // namespace alidade::ui
