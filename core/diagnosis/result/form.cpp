#include "core/diagnosis/result/form.h"

namespace alidade {

namespace {

constexpr std::array<std::string_view, 9> functionNames = {
    "harmonic", "bump", "step", "hinge", "exponential", "power", "hysteresis", "walk", "per_place"};
constexpr std::array<std::string_view, 10> argumentNames = {
    "s", "t", "a", "e", "horizontal circle", "vertical circle", "leg", "face", "position", "round"};

}  // namespace

std::string_view nameOf(FormFunction function) {
  return functionNames[static_cast<std::size_t>(function)];
}

std::string_view nameOf(FormArgument argument) {
  return argumentNames[static_cast<std::size_t>(argument)];
}

bool Form::isOfKind(const Form& other) const {
  return carrier == other.carrier && function == other.function && of == other.of &&
         turnsWithFace == other.turnsWithFace;
}

int Form::count() const {
  switch (function) {
    case FormFunction::Bump:
      return 2;
    case FormFunction::Step:
    case FormFunction::Hinge:
    case FormFunction::Exponential:
      return 1;
    case FormFunction::Harmonic:
      return of == FormArgument::T ? 1 : 0;
    case FormFunction::Power:
    case FormFunction::Hysteresis:
    case FormFunction::Walk:
    case FormFunction::PerPlace:
      break;
  }
  return 0;
}

}  // namespace alidade
