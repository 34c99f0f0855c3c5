#include "core/diagnosis/evidence/width.h"

#include <cmath>

namespace alidade {

std::vector<Width> evenly(std::initializer_list<double> sigmas) {
  std::vector<Width> widths;
  for (const double sigma : sigmas) widths.push_back({sigma, -std::log(static_cast<double>(sigmas.size()))});
  return widths;
}

std::vector<Width> andFarWider(std::vector<Width> widths, double sigma) {
  constexpr double chance = 0.01;
  for (Width& width : widths) width.logChance += std::log1p(-chance);
  widths.push_back({sigma, std::log(chance)});
  return widths;
}

}  // namespace alidade
