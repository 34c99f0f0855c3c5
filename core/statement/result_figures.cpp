#include "core/statement/result_figures.h"

#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr int asUncertain = -1;

constexpr ArcFigure ofArc[] = {
    {.id = "x",
     .key = nullptr,
     .unit = "mm",
     .decimals = asUncertain,
     .title = PHRASE_LATER("Phrase", "Δx (u), mm"),
     .remark = PHRASE_LATER("Phrase", "Centre of the arc, right positive, with its standard uncertainty"),
     .name = PHRASE_LATER("Phrase", "x of the centre %1"),
     .value = [](const ArcSummary& arc) { return arc.circle().x; },
     .sigma = [](const ArcSummary& arc) { return arc.sigma.x; }},
    {.id = "y",
     .key = nullptr,
     .unit = "mm",
     .decimals = asUncertain,
     .title = PHRASE_LATER("Phrase", "Δy (u), mm"),
     .remark = PHRASE_LATER("Phrase", "Centre of the arc, up positive, with its standard uncertainty"),
     .name = PHRASE_LATER("Phrase", "y of the centre %1"),
     .value = [](const ArcSummary& arc) { return arc.circle().y; },
     .sigma = [](const ArcSummary& arc) { return arc.sigma.y; }},
    {.id = "radius",
     .key = nullptr,
     .unit = "mm",
     .decimals = asUncertain,
     .title = PHRASE_LATER("Phrase", "R (u), mm"),
     .remark = PHRASE_LATER("Phrase", "Fitted radius with its standard uncertainty"),
     .name = PHRASE_LATER("Phrase", "Radius of the arc"),
     .value = [](const ArcSummary& arc) { return arc.circle().radius; },
     .sigma = [](const ArcSummary& arc) { return arc.sigma.radius; }},
    {.id = "sightings",
     .key = "readings",
     .unit = "",
     .decimals = 0,
     .title = PHRASE_LATER("Phrase", "Sightings"),
     .remark = "",
     .name = PHRASE_LATER("Phrase", "Number of sightings"),
     .value = [](const ArcSummary& arc) { return static_cast<double>(arc.sightings); },
     .isOfEachRepeat = true},
    {.id = "residual_rms",
     .key = "residual_rms_arcsec",
     .unit = "arcsec",
     .decimals = 2,
     .title = PHRASE_LATER("Phrase", "rms, ″"),
     .remark = PHRASE_LATER("Phrase", "Root mean square of the residuals of all readings of the arc"),
     .name = PHRASE_LATER("Phrase", "Root mean square of the residuals"),
     .value = [](const ArcSummary& arc) { return arc.residualRms; },
     .isOfEachRepeat = true},
    {.id = "reduced_chi_square",
     .key = "reduced_chi2",
     .unit = "",
     .decimals = 2,
     .title = PHRASE_LATER("Phrase", "Reduced χ²"),
     .remark = PHRASE_LATER("Phrase", "About 1 where the readings scatter as stated"),
     .name = PHRASE_LATER("Phrase", "Reduced χ²"),
     .value = [](const ArcSummary& arc) { return arc.reducedChiSquare(); }},
    {.id = "redundancy",
     .key = "degrees_of_freedom",
     .unit = "",
     .decimals = 0,
     .title = PHRASE_LATER("Phrase", "Redundancy"),
     .remark = PHRASE_LATER(
         "Phrase", "Sum of the redundancies of its readings; unknowns of several arcs count in part"),
     .name = PHRASE_LATER("Phrase", "Redundancy"),
     .value = [](const ArcSummary& arc) { return arc.degreesOfFreedom; }},
};

constexpr MeasuredFigure ofIntersection[] = {
    {.id = "across_plane",
     .name = PHRASE_LATER("Phrase", "Δz, perpendicular to the plane of the arc"),
     .distribution = "Student's t",
     .isNonNegative = false,
     .length = &MeasuredIntersection::across},
    {.id = "distance_from_axis",
     .name = PHRASE_LATER("Phrase", "d = √(Δd² + Δz²), whole distance from the axis"),
     .distribution = "Rice",
     .isNonNegative = true,
     .length = &MeasuredIntersection::distance},
};

}  // namespace

std::string ArcFigure::nameAt(int axisDeg) const {
  return Phrase::of(name, axisDeg == 0 ? "O1" : "O2");
}

std::span<const ArcFigure> arcFigures() {
  return ofArc;
}

std::span<const MeasuredFigure> measuredFigures() {
  return ofIntersection;
}

}  // namespace alidade
