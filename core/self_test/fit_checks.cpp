#include <cmath>
#include <nlohmann/json.hpp>

#include "core/adjustment/result/session_fit.h"
#include "core/base/phrase.h"
#include "core/self_test/check_families.h"
#include "core/self_test/references.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {

namespace {

using Json = nlohmann::json;

/// A reading is rounded to 4e-16 rad, 1e-12 mm at the target; an arc of 20° magnifies this some hundred
/// times.
constexpr CheckTolerance ofLength = {
    .absolute = 1e-9,
    .reason = PHRASE_LATER("Phrase",
                           "1e-9 mm, a millionth of the smallest uncertainty: the fit stops within 1e-9 σ of "
                           "the minimum, and rounding in double precision is a thousandth of that")};
constexpr CheckTolerance ofSum = {
    .absolute = 1e-8,
    .relative = 1e-8,
    .reason = PHRASE_LATER("Phrase",
                           "1e-8: the fit stops within 1e-9 σ of the minimum, where σ and χ² are smooth")};

SelfCheck against(const Json& object, const char* key, const std::string& name, double found,
                  const CheckTolerance& tolerance) {
  return numberCheck(CheckGroup::Fits, name, object.value(key, ""), found, tolerance);
}

void addArc(std::vector<SelfCheck>& checks, const std::string& session, const Json& reference,
            const SessionFit& fit) {
  const int axisDeg = reference.at("axis_deg").get<int>();
  const std::string name = session + ", " + std::to_string(axisDeg) + "°: ";
  const ArcFit* arc = fit.arcAt(axisDeg);
  if (!arc) return checks.push_back(brokenCheck(CheckGroup::Fits, name + "R", "no fit"));
  checks.push_back(against(reference, "x", name + "Δx (mm)", arc->circle.x, ofLength));
  checks.push_back(against(reference, "y", name + "Δy (mm)", arc->circle.y, ofLength));
  checks.push_back(against(reference, "radius", name + "R (mm)", arc->circle.radius, ofLength));
  checks.push_back(against(reference, "sigma_radius", name + "σ(R) (mm)", std::sqrt(arc->cofactor[2][2]),
                           {.relative = ofSum.relative, .reason = ofSum.reason}));
  checks.push_back(against(reference, "chi_square", name + "χ²", arc->chiSquare, ofSum));
}

void addSession(std::vector<SelfCheck>& checks, const Json& reference) {
  const std::string name = reference.at("name").get<std::string>();
  std::string file = reference.at("session").get<std::string>();
  file.erase(0, file.find_last_of('/') + 1);
  const Result<Session> session = readSession(referenceText(file));
  if (!session) return checks.push_back(brokenCheck(CheckGroup::Fits, name, session.problem().text()));
  Examined examined = examine(*session);
  if (!examined.measurement || !examined.problems.empty())
    return checks.push_back(brokenCheck(CheckGroup::Fits, name, examined.problems.front().text()));
  Measurement& measurement = *examined.measurement;
  measurement.relation =
      reference.at("relation") == "planar" ? VerticalAngleRelation::Planar : VerticalAngleRelation::Exact;
  const SessionFit fit = fitSession(measurement);
  for (const Json& arc : reference.at("arcs")) addArc(checks, name, arc, fit);
  if (!reference.contains("intersection")) return;
  if (!fit.intersection) return checks.push_back(brokenCheck(CheckGroup::Fits, name + ": Δd", "no Δd"));
  checks.push_back(against(reference, "intersection", name + ": Δd (mm)", fit.intersection->value, ofLength));
  // The reference includes only the readings, with their stated σ.
  checks.push_back(against(reference, "sigma_intersection", name + ": σ(Δd) (mm)",
                           fit.intersection->budget.front().sigma / fit.noise.factor,
                           {.relative = ofSum.relative, .reason = ofSum.reason}));
}

}  // namespace

std::vector<SelfCheck> fitChecks(const std::string& fits) {
  std::vector<SelfCheck> checks;
  try {
    for (const Json& reference : Json::parse(fits)) addSession(checks, reference);
  } catch (const Json::exception& error) {
    checks.push_back(brokenCheck(CheckGroup::Fits, "results.json", error.what()));
  }
  return checks;
}

}  // namespace alidade
