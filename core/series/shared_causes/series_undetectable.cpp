#include "core/series/shared_causes/searched_series.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/diagnosis/result/thresholds.h"

namespace alidade {

void addUndetectable(SeriesDiagnosis& diagnosis, const SearchedSeries& series) {
  for (const EffectColumns& columns : series.evidence.front().columns->effects()) {
    if (columns.effect->response == Response::AllOrNothing) continue;
    if (std::ranges::find(series.leftOut, columns.effect->id) != series.leftOut.end()) continue;
    const auto count = static_cast<Eigen::Index>(columns.effect->parameters.size());
    Eigen::VectorXd influence = Eigen::VectorXd::Zero(count);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(columns.count),
                                                   static_cast<Eigen::Index>(columns.count));
    for (std::size_t s = 0; s < series.sessions(); ++s) {
      influence += Eigen::Map<const Eigen::VectorXd>(&series.evidence[s].influence[columns.first], count) /
                   static_cast<double>(series.sessions());
      normal += series.sums[s].plainNormal(columns, columns);
    }
    const double moves = influence.norm();
    if (!(moves > thresholds.negligibleInfluence)) continue;
    const Eigen::VectorXd along = influence / moves;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(normal.cols());
    weights.head(count) = along;
    if (columns.effect->response == Response::Bent)
      weights.tail(3) << along[0] * along[0] / 2, along[0] * along[1], along[1] * along[1] / 2;
    const double visible = std::sqrt(std::max(weights.dot(normal * weights), 0.0));
    if (visible < clearlySeparated())
      diagnosis.undetectable.push_back({std::string(columns.effect->id), moves, visible});
  }
  std::ranges::sort(diagnosis.undetectable, std::greater{}, &UndetectableEffect::influence);
}

}  // namespace alidade
