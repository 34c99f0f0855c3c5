#pragma once

#include <memory>

namespace alidade::ui {
struct ArcPicture;
struct ResidualPicture;
}  // namespace alidade::ui

namespace alidade {

/// The contents of the charts, computed on the thread of the fit, so that the window only paints them.
struct EvaluationPictures {
  std::shared_ptr<const ui::ArcPicture> arcs;
  std::shared_ptr<const ui::ResidualPicture> residuals;
};

}  // namespace alidade
