#include "ui/charts/evaluation_pictures.h"

#include "core/base/threads.h"
#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

Evaluation drawn(Evaluation evaluation, const std::stop_token& stop) {
  if (stop.stop_requested()) return evaluation;
  auto pictures = std::make_shared<EvaluationPictures>();
  const auto& measurement = evaluation.examined.measurement;
  doAll(threadsFor(measurement ? measurement->rows : 0),
        {[&] { pictures->arcs = arcPictureOf(evaluation); },
         [&] { pictures->residuals = residualPictureOf(evaluation); }});
  evaluation.pictures = std::move(pictures);
  return evaluation;
}

std::shared_ptr<const ArcPicture> arcPictureOf(const Evaluation& evaluation) {
  return evaluation.pictures ? evaluation.pictures->arcs
                             : std::make_shared<const ArcPicture>(arcPicture(evaluation));
}

std::shared_ptr<const ResidualPicture> residualPictureOf(const Evaluation& evaluation) {
  return evaluation.pictures ? evaluation.pictures->residuals
                             : std::make_shared<const ResidualPicture>(residualPicture(evaluation));
}

}  // namespace alidade::ui
