#include "core/series/shared_causes/offered_effects.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/kept_form.h"
#include "core/diagnosis/shared_form.h"

namespace alidade {

namespace {

struct FormInSession {
  std::size_t session;
  const FoundForm* form;
};

const std::string& ownerOf(const SeriesMember& member, const Form& form) {
  return isOfCircles(form.carrier) ? member.instrument : member.guideway;
}

/// The last amplitude of the form in units of its u.
double sharpness(const FormInSession& found) {
  if (found.form->parameters.empty()) return 0;
  const FormNumber& amplitude = found.form->parameters.back();
  return amplitude.sigma > 0 ? std::abs(amplitude.value) / amplitude.sigma : 0;
}

/// `first` and the forms that agree with `first`, at most one from each other session of the same owner.
/// Empty if the form is free or its owner has no serial number.
std::vector<FormInSession> groupOf(const FormInSession& first, const std::vector<FormInSession>& all,
                                   const std::vector<SeriesMember>& members) {
  const Form& form = first.form->form;
  const std::string& owner = ownerOf(members[first.session], form);
  std::vector<FormInSession> group;
  if (form.isFree() || owner.empty()) return group;
  group.push_back(first);
  for (const FormInSession& other : all)
    if (ownerOf(members[other.session], form) == owner &&
        std::ranges::find(group, other.session, &FormInSession::session) == group.end() &&
        agrees(*first.form, *other.form))
      group.push_back(other);
  return group;
}

OfferedEffect offerOf(const std::vector<FormInSession>& group, const SeriesDiagnosis& diagnosis) {
  const Form& form = group.front().form->form;
  std::vector<const FoundForm*> same;
  OfferedEffect offer;
  for (const FormInSession& found : group) {
    offer.sessions.push_back(found.session);
    if (isOfOneKind(found.form->form, form)) same.push_back(found.form);
  }
  std::ranges::sort(offer.sessions);
  offer.form = meanOf(same);
  const SeriesMember& first = diagnosis.sessions[offer.sessions.front()];
  Session owner;
  owner.device.serial = first.guideway;
  owner.instrument.serial = first.instrument;
  offer.effect = ownEffectOf(offer.form, owner);
  offer.effect.from =
      Phrase::of("found in %1 sessions, first in %2", offer.sessions.size(), quotation(first.name));
  const auto alike = std::ranges::count_if(
      diagnosis.offered, [&](const OfferedEffect& other) { return other.effect.name == offer.effect.name; });
  if (alike > 0) offer.effect.id += "-" + std::to_string(alike + 1);
  return offer;
}

}  // namespace

void addOfferedEffects(SeriesDiagnosis& diagnosis) {
  constexpr std::size_t fewest = 3;
  std::vector<FormInSession> left;
  for (std::size_t s = 0; s < diagnosis.sessions.size(); ++s)
    for (const FoundForm& form : diagnosis.sessions[s].diagnosis.forms) left.push_back({s, &form});
  std::ranges::stable_sort(left, std::greater{}, sharpness);
  while (true) {
    std::vector<FormInSession> most;
    for (const FormInSession& first : left)
      if (auto group = groupOf(first, left, diagnosis.sessions); group.size() > most.size())
        most = std::move(group);
    if (most.size() < fewest) return;
    diagnosis.offered.push_back(offerOf(most, diagnosis));
    std::erase_if(left, [&](const FormInSession& found) {
      return std::ranges::find(most, found.form, &FormInSession::form) != most.end();
    });
  }
}

}  // namespace alidade
