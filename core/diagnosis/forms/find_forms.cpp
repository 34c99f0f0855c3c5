#include "core/diagnosis/forms/find_forms.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/candidates/candidates.h"
#include "core/diagnosis/forms/found_form.h"

namespace alidade {

bool beatNothing(const std::vector<WeighedForm>& all) {
  return !all.empty() && all.front().amplitudes.size() > 0 &&
         logSumOf(all) + std::log(PriorOdds{}.shape) > std::log(formThresholds.odds);
}

namespace {

/// The forms that can enter an average: likely forms with known amplitudes.
std::vector<WeighedForm> likelyOf(const std::vector<WeighedForm>& all) {
  std::vector<WeighedForm> likely;
  for (const WeighedForm& each : all)
    if (likely.size() < formThresholds.mostAveraged && each.amplitudes.size() > 0 &&
        each.logPosterior() > all.front().logPosterior() - formThresholds.averagedWithin)
      likely.push_back(each);
  return likely;
}

}  // namespace

FoundForms findForms(FormSystem& system, const FormReadings& readings,
                     const std::vector<FormFamily>& families, const FormChoice& choice,
                     const std::stop_token& stop) {
  FoundForms found;
  while (found.forms.size() < formThresholds.mostForms) {
    const std::vector<WeighedForm> all = weighForms(system, readings, families, stop);
    if (all.empty() || !choice.isNamed(all)) break;
    const WeighedForm& first = all.front();
    FoundForm& form = found.forms.emplace_back(foundForm(first, all));
    for (const Form& other : lookAlikesOfFirst(system, readings, all))
      form.indistinguishableFrom.push_back({other});
    addCleanRange(form, readings);
    choice.note(first, form);
    found.families.push_back(*std::ranges::find_if(families, [&](const FormFamily& family) {
      return family.form.isOfKind(first.form) && family.form.order == first.form.order;
    }));
    found.likely.push_back(likelyOf(all));
    system.takeUp(formColumns(readings, first.form));
    found.numbers += static_cast<int>(first.amplitudes.size()) + first.form.count();
    if (!choice.isAnythingLeft(found.numbers)) break;
  }
  return found;
}

}  // namespace alidade
