#include "ui/document/known_entry.h"

#include <charconv>
#include <map>
#include <utility>

#include "core/effects/known_sizes.h"

namespace alidade::ui {

namespace {

constexpr std::string_view ofInstrument = "instrument.known[", ofDevice = "device.known[";

/// The entries of each catalogued number, those of the instrument first; unknown numbers are under null.
std::map<const EffectParameter*, std::vector<KnownRef>> entriesByNumber(const Session& session) {
  std::map<const EffectParameter*, std::vector<KnownRef>> entries;
  for (const KnownOwner owner : {KnownOwner::Instrument, KnownOwner::Device}) {
    const std::vector<KnownSize>& list = knownBy(session, owner);
    for (std::size_t i = 0; i < list.size(); ++i)
      entries[findParameter(list[i].effect, list[i].parameter, list[i].unit)].push_back({owner, i});
  }
  return entries;
}

}  // namespace

KnownOwner ownerOf(const Effect& effect) {
  return effect.source == ErrorSource::Guideway ? KnownOwner::Device : KnownOwner::Instrument;
}

const std::vector<KnownSize>& knownBy(const Session& session, KnownOwner owner) {
  return owner == KnownOwner::Device ? session.device.known : session.instrument.known;
}

std::vector<KnownSize>& knownBy(Session& session, KnownOwner owner) {
  return owner == KnownOwner::Device ? session.device.known : session.instrument.known;
}

const KnownSize* knownSize(const Session& session, const KnownRef& ref) {
  const std::vector<KnownSize>& list = knownBy(session, ref.owner);
  return ref.index < list.size() ? &list[ref.index] : nullptr;
}

Place placeOf(const KnownRef& ref, std::string_view member) {
  std::string field(ref.owner == KnownOwner::Device ? ofDevice : ofInstrument);
  field += std::to_string(ref.index) + "]";
  if (!member.empty()) field.append(".").append(member);
  return {.field = field};
}

std::optional<KnownPlace> knownAt(const Place& place) {
  KnownPlace known;
  std::string_view rest = place.field;
  if (rest.starts_with(ofDevice))
    known.ref.owner = KnownOwner::Device;
  else if (!rest.starts_with(ofInstrument))
    return std::nullopt;
  rest.remove_prefix(rest.find('[') + 1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), known.ref.index);
  if (error != std::errc()) return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.starts_with(']')) return std::nullopt;
  rest.remove_prefix(rest.starts_with("].") ? 2 : 1);
  known.member = rest;
  return known;
}

std::vector<KnownRow> knownRows(const Session& session) {
  auto entries = entriesByNumber(session);
  std::vector<KnownRow> rows;
  for (const Effect& effect : effectCatalogue()) {
    if (!hasSizes(effect)) continue;
    for (const EffectParameter& parameter : effect.parameters) {
      const std::vector<KnownRef> own = std::exchange(entries[&parameter], {});
      if (own.empty()) rows.push_back({&effect, &parameter});
      for (const KnownRef& entry : own) rows.push_back({&effect, &parameter, entry, entry != own.front()});
    }
  }
  for (const KnownRef& entry : entries[nullptr]) rows.push_back({nullptr, nullptr, entry});
  return rows;
}

}  // namespace alidade::ui
