#include "core/adjustment/result/two_faces.h"

#include <cmath>

#include "core/observation/visits.h"

namespace alidade {

namespace {

/// Least spread (rms) of sin e that separates c from i.
constexpr double leastSpread = 1e-3;

std::optional<FaceDifference> differenceOf(const Measurement& measurement, std::size_t arc,
                                           const Visit& visit) {
  FaceDifference difference;
  difference.arc = arc;
  const Sighting *one = nullptr, *two = nullptr;
  for (const std::size_t i : visit.sightings) {
    const Sighting& sighting = measurement.arcs[arc].sightings[i];
    (sighting.face == 1 ? one : two) = &sighting;
    (sighting.face == 1 ? difference.faceOne : difference.faceTwo) = i;
  }
  if (!one || !two) return std::nullopt;
  // Reduced readings of face 2 are already converted to face 1, which removes 180° and 360°.
  const double down = measurement.verticalCircle == VerticalCircle::Zenith ? 1 : -1;
  difference.elevation = (one->e + two->e) * 0.5;
  difference.doubleCollimation = wrapped(one->a - two->a);
  difference.index = (two->e - one->e) * (0.5 * down);
  return difference;
}

/// Sums for the straight line w = c + i·s with the weights p.
struct LineSums {
  double p = 0, ps = 0, pss = 0, pw = 0, psw = 0;

  double spread() const { return std::sqrt(std::max(0.0, pss / p - ps / p * (ps / p))); }
  double determinant() const { return p * pss - ps * ps; }
};

void fitCourse(TwoFaces& faces, Angle sigma) {
  LineSums sums;
  for (const FaceDifference& visit : faces.visits) {
    const double e = visit.elevation.radians(), s = std::sin(e);
    const double w = visit.doubleCollimation.radians() * std::cos(e) / 2;
    const double p = 2 / std::pow(sigma.radians() * std::cos(e), 2);
    sums.p += p;
    sums.ps += p * s;
    sums.pss += p * s * s;
    sums.pw += p * w;
    sums.psw += p * s * w;
  }
  const bool isLine = faces.visits.size() >= 3 && sums.spread() > leastSpread;
  const double i = isLine ? (sums.p * sums.psw - sums.ps * sums.pw) / sums.determinant() : 0;
  const double c = (sums.pw - i * sums.ps) / sums.p;
  for (FaceDifference& visit : faces.visits) {
    const double e = visit.elevation.radians();
    const double course = 2 * (c + i * std::sin(e)) / std::cos(e);
    visit.fromCourse = visit.doubleCollimation - Angle::fromRadians(course);
    faces.horizontal.chiSquare += std::pow(visit.fromCourse.radians() / sigma.radians(), 2) / 2;
  }
  faces.horizontal.degreesOfFreedom = static_cast<int>(faces.visits.size()) - (isLine ? 2 : 1);
  const double scale = noiseScale(faces.horizontal.chiSquare, faces.horizontal.degreesOfFreedom).factor;
  const double variance = isLine ? sums.pss / sums.determinant() : 1 / sums.p;
  faces.collimation = {Angle::fromRadians(c), Angle::fromRadians(scale * std::sqrt(variance))};
  if (!isLine) return;
  const double tiltVariance = sums.p / sums.determinant();
  faces.trunnionTilt = {Angle::fromRadians(i), Angle::fromRadians(scale * std::sqrt(tiltVariance))};
}

void fitIndex(TwoFaces& faces, Angle sigma) {
  const auto count = static_cast<double>(faces.visits.size());
  Angle sum;
  for (const FaceDifference& visit : faces.visits) sum = sum + visit.index;
  faces.index.value = sum * (1 / count);
  for (const FaceDifference& visit : faces.visits)
    faces.vertical.chiSquare +=
        2 * std::pow((visit.index - faces.index.value).radians() / sigma.radians(), 2);
  faces.vertical.degreesOfFreedom = static_cast<int>(faces.visits.size()) - 1;
  const double scale = noiseScale(faces.vertical.chiSquare, faces.vertical.degreesOfFreedom).factor;
  faces.index.sigma = sigma * (scale / std::sqrt(2 * count));
}

}  // namespace

double FaceScatter::ratio() const {
  return degreesOfFreedom > 0 ? std::sqrt(chiSquare / degreesOfFreedom) : 0;
}

std::optional<TwoFaces> compareFaces(const Measurement& measurement) {
  TwoFaces faces;
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc)
    for (const Visit& visit : visitsOf(measurement.arcs[arc]))
      if (const auto difference = differenceOf(measurement, arc, visit)) faces.visits.push_back(*difference);
  if (faces.visits.empty()) return std::nullopt;
  fitCourse(faces, measurement.sigmaHorizontal);
  fitIndex(faces, measurement.sigmaVertical);
  return faces;
}

}  // namespace alidade
