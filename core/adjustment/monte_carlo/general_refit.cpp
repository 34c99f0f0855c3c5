#include <algorithm>
#include <utility>

#include "core/adjustment/monte_carlo/refit.h"

namespace alidade {

namespace {

constexpr double farBelowScatter = 1e-6;  // relative to the spread of the draws, some 1 σ

class GeneralRefit : public Refit {
 public:
  explicit GeneralRefit(const RefitTask& task)
      : m_task(task),
        m_drawn(task.fitted),
        m_options{
            .terms = estimatedTerms(task.fitted), .maximumIterations = 300, .tolerance = farBelowScatter} {
    for (const ArcFit& arc : task.fit.arcs) m_starts.push_back(arc.circle);
    m_arcsApart = haveNothingInCommon(task.fitted);
  }

  void refit(std::span<const Draw> draws, std::span<double> centres) override {
    for (std::size_t i = 0; i < draws.size(); ++i) {
      take(draws[i]);
      const auto own = centres.subspan(i * m_task.centres(), m_task.centres());
      m_arcsApart ? fitApart(own) : fitTogether(own);
    }
  }

 private:
  void take(const Draw& draw) {
    const Measurement& read = m_task.fitted;
    m_drawn.distance = read.distance + read.sigmaDistance * draw.normals[DrawPlan::distance];
    if (read.radiusModel == RadiusModel::Known)
      m_drawn.nominalRadius = read.nominalRadius + read.sigmaRadius * draw.normals[DrawPlan::radius];
    for (std::size_t t = 0; t < m_options.terms.size(); ++t)
      m_options.terms[t].priorValue = m_options.terms[t].priorSigma * draw.normals[DrawPlan::firstTerm + t];
    for (std::size_t arc = 0; arc < read.arcs.size(); ++arc) takeArc(draw, arc);
  }

  void takeArc(const Draw& draw, std::size_t arc) {
    const Measurement& read = m_task.fitted;
    const double* zeros = &draw.normals[m_task.plan.zeros(arc)];
    const Angle zeroA = read.sigmaOfZeroHorizontal(read.arcs[arc]) * (draw.zeroScale * zeros[0]),
                zeroE = read.sigmaOfZeroVertical(read.arcs[arc]) * (draw.zeroScale * zeros[1]);
    m_drawn.arcs[arc].zeroElevation = read.arcs[arc].zeroElevation - zeroE;
    for (std::size_t i = 0; i < read.arcs[arc].sightings.size(); ++i) {
      const Sighting& sighting = read.arcs[arc].sightings[i];
      const double* noise = &draw.normals[m_task.plan.readings(arc, i)];
      Sighting& drawn = m_drawn.arcs[arc].sightings[i];
      drawn.a = sighting.a + zeroA + read.sigmaHorizontal * (draw.scale * noise[0]);
      drawn.e = sighting.e + zeroE + read.sigmaVertical * (draw.scale * noise[1]);
      if (sighting.slider) drawn.slider = *sighting.slider + read.sigmaSlider * (draw.scale * noise[2]);
    }
  }

  void fitApart(std::span<double> centres) const {
    for (std::size_t i = 0; i < m_drawn.arcs.size(); ++i) {
      const auto fit = fitArc(m_drawn, m_drawn.arcs[i], {.start = m_starts[i], .tolerance = farBelowScatter});
      const bool isFound = fit && fit->converged();
      centres[2 * i] = isFound ? fit->circle.x : missingCentre;
      centres[2 * i + 1] = isFound ? fit->circle.y : missingCentre;
    }
  }

  void fitTogether(std::span<double> centres) const {
    const JointFit fit = fitJointly(m_drawn, m_starts, m_options);
    for (std::size_t i = 0; i < m_drawn.arcs.size(); ++i) {
      const auto value = [&](Unknown::Kind kind) {
        return fit.converged() ? fit.values[fit.indexOf({.kind = kind, .arc = i})] : missingCentre;
      };
      centres[2 * i] = value(Unknown::Kind::CentreX);
      centres[2 * i + 1] = value(Unknown::Kind::CentreY);
    }
  }

  RefitTask m_task;
  Measurement m_drawn;
  JointFitOptions m_options;
  std::vector<Circle> m_starts;
  bool m_arcsApart = false;
};

}  // namespace

std::unique_ptr<Refit> generalRefit(const RefitTask& task) {
  return std::make_unique<GeneralRefit>(task);
}

}  // namespace alidade
