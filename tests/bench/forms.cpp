// Measures how well the forms of uncatalogued effects are named, in sessions with a known form. By kind it
// counts forms named right, and right ones among the look-alikes. It also reports shape numbers and
// amplitudes within 3 u, look-alikes, the stated probability, the shrinkage on held-out readings, and the
// time of a diagnosis. Argument: a folder with truth.json and sessions/.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/answers/diagnosis_json.h"
#include "core/diagnosis/diagnose.h"
#include "core/session/session_file.h"

namespace {

using namespace alidade;
using Json = nlohmann::ordered_json;

struct Score {
  int sessions = 0, strong = 0, named = 0, right = 0, inClass = 0, shapes = 0, shapesWithin = 0, sizes = 0,
      sizesWithin = 0, lookAlikes = 0;
  double probability = 0, shrinkage = 0, milliseconds = 0;
};

bool isSame(const Json& form, const Json& truth) {
  for (const char* key : {"carrier", "form", "of"})
    if (form.value(key, "") != truth.value(key, "")) return false;
  if (!truth.contains("order")) return true;
  const Json& own = form.contains("parameters") ? form["parameters"] : form;
  return own.contains("order") && own["order"] == truth["order"];
}

void addNumbers(const Json& parameters, const Json& truth, Score& score) {
  for (const auto& [name, value] : truth.items()) {
    const std::string sigma = "standard_uncertainty_" + name;
    if (name == "order" || !parameters.contains(sigma) || !parameters[sigma].is_number()) continue;
    // A harmonic's amplitude has no sign.
    const double off = std::abs(parameters[name].get<double>()) - std::abs(value.get<double>());
    const bool isWithin = std::abs(off) <= 3 * parameters[sigma].get<double>();
    const bool isSize =
        name.find("amplitude") != std::string::npos || name.find("arcsec") != std::string::npos;
    ++(isSize ? score.sizes : score.shapes);
    (isSize ? score.sizesWithin : score.shapesWithin) += isWithin ? 1 : 0;
  }
}

void add(const Json& result, const Json& truth, Score& score) {
  const Json forms = result.value("forms", Json::array());
  if (forms.empty()) return;
  const Json& form = forms.front();
  ++score.named;
  score.probability += form["probability"].get<double>();
  score.lookAlikes += static_cast<int>(form["indistinguishable_from"].size());
  if (form["shrink"]["held_out"].is_number()) score.shrinkage += form["shrink"]["held_out"].get<double>();
  if (!truth.contains("form")) return;
  const Json& expected = truth["form"];
  const bool isRight = isSame(form, expected);
  score.right += isRight ? 1 : 0;
  bool isIn = isRight;
  for (const Json& other : form["indistinguishable_from"]) isIn = isIn || isSame(other, expected);
  score.inClass += isIn ? 1 : 0;
  if (isRight) addNumbers(form["parameters"], expected, score);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: alidade_forms FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  std::ifstream file(folder + "/truth.json");
  const Json truths = Json::parse(file);
  std::map<std::string, Score> scores;
  for (const auto& [name, truth] : truths.items()) {
    const auto session = loadSession(folder + "/sessions/" + name + ".alidade");
    if (!session) continue;
    const Session& own = *session;
    const auto begin = std::chrono::steady_clock::now();
    const auto diagnosis = diagnose(*examine(own).measurement);
    const double took =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    if (!diagnosis) continue;
    Score& score = scores[truth["kind"].get<std::string>()];
    ++score.sessions;
    score.milliseconds += took;
    score.strong += truth.value("beyond_catalogue_sigma", 0.0) >= 10 ? 1 : 0;
    add(diagnosisDocument(name, *diagnosis, {}), truth, score);
  }
  std::printf("%-28s %5s %5s %5s %5s %5s %7s %7s %6s %6s %6s %6s\n", "kind", "n", ">10s", "named", "right",
              "class", "shapes", "sizes", "alike", "P", "held", "ms");
  for (const auto& [kind, s] : scores) {
    const double named = std::max(s.named, 1);
    std::printf("%-28s %5d %5d %5d %5d %5d %3d/%-3d %3d/%-3d %6.1f %6.3f %6.3f %6.1f\n", kind.c_str(),
                s.sessions, s.strong, s.named, s.right, s.inClass, s.shapesWithin, s.shapes, s.sizesWithin,
                s.sizes, s.lookAlikes / named, s.probability / named, s.shrinkage / named,
                s.milliseconds / s.sessions);
  }
}
