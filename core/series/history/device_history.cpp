#include "core/series/history/device_history.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/session/other_circle.h"
#include "core/session/readings_digest.h"

namespace alidade {

namespace {

bool allShare(const std::vector<Epoch>& epochs, bool (*same)(const Epoch&, const Epoch&)) {
  return std::ranges::all_of(epochs, [&](const Epoch& epoch) { return same(epochs.front(), epoch); });
}

DatedValue dated(const Epoch& epoch, double value, double u) {
  return {.date = epoch.date,
          .day = epoch.day,
          .value = value,
          .u = u,
          .apart = u,
          .of = epoch.title,
          .file = epoch.file};
}

/// The tolerance of the latest session that has one.
std::optional<double> toleranceOf(const std::vector<Epoch>& epochs) {
  std::optional<double> tolerance;
  for (const Epoch& epoch : epochs)
    if (epoch.tolerance) tolerance = epoch.tolerance;
  return tolerance;
}

QuantityHistory ofFit(const std::vector<Epoch>& epochs) {
  std::vector<DatedValue> values;
  values.reserve(epochs.size());
  for (const Epoch& epoch : epochs) values.push_back(dated(epoch, epoch.ofFit.value, epoch.ofFit.sigma));
  History history = historyOf(std::move(values), 0, epochs.back().coverage);
  history.tolerance = toleranceOf(epochs);
  return {"intersection_of_fit", "mm", std::move(history)};
}

DeviceHistory historyOfDevice(std::vector<Epoch> epochs) {
  std::ranges::stable_sort(epochs, {}, &Epoch::day);
  DeviceHistory device{.name = epochs.front().device, .serial = epochs.front().deviceSerial};
  device.hasOneInstrument = allShare(epochs, haveOneInstrument);
  device.hasBothCircles =
      !allShare(epochs, [](const Epoch& one, const Epoch& other) { return one.circle == other.circle; });
  device.quantities.push_back({"intersection", "mm", intersectionHistory(epochs)});
  device.quantities.push_back(ofFit(epochs));
  FoundQuantities lengths, causes;
  for (const Epoch& epoch : epochs) {
    for (std::size_t i = 0; i < epoch.lengths.size(); ++i)
      lengths.add(epoch.lengths[i].id, "mm",
                  dated(epoch, epoch.lengths[i].value, std::sqrt(epoch.covariance(i, i))));
    for (const EpochCause& cause : epoch.causes) {
      const bool isOther = device.hasBothCircles && epoch.circle == VerticalCircle::Elevation;
      const OnOtherCircle on = (isOther ? onOtherCircle(cause.effect, cause.parameter) : std::nullopt)
                                   .value_or(OnOtherCircle{cause.parameter});
      causes.add(cause.effect + ": " + on.parameter, cause.unit,
                 dated(epoch, on.sign * cause.value, cause.u));
    }
  }
  lengths.moveTo(device.quantities, epochs.back().coverage);
  causes.moveTo(device.quantities, epochs.back().coverage);
  for (const auto& [first, second] : pairsOf(epochs.size()))
    device.congruences.push_back(congruenceOf(epochs, first, second));
  device.epochs = std::move(epochs);
  return device;
}

}  // namespace

History intersectionHistory(const std::vector<Epoch>& epochs) {
  const bool oneDevice = allShare(epochs, haveOneDevice), oneInstrument = allShare(epochs, haveOneInstrument);
  // The share of each lasting effect in each session, mm; 0 in a session that does not list the effect.
  std::map<std::string, std::vector<double>> shares;
  for (std::size_t i = 0; i < epochs.size(); ++i)
    for (const LastingShare& share : epochs[i].lasting)
      if (share.source == ErrorSource::Guideway ? oneDevice : oneInstrument) {
        std::vector<double>& sigmas = shares[share.effect];
        sigmas.resize(epochs.size());
        sigmas[i] = share.sigma;
      }
  double shared = 0;
  std::vector<double> own;
  own.reserve(epochs.size());
  for (const Epoch& epoch : epochs) own.push_back(std::pow(epoch.intersection.sigma, 2));
  if (epochs.size() > 1)
    for (const auto& [effect, sigmas] : shares) {
      double mean = 0;
      for (const double sigma : sigmas) mean += sigma / static_cast<double>(sigmas.size());
      shared += mean * mean;
      for (std::size_t i = 0; i < own.size(); ++i)
        own[i] += std::pow(sigmas[i] - mean, 2) - sigmas[i] * sigmas[i];
    }
  std::vector<DatedValue> values;
  for (std::size_t i = 0; i < epochs.size(); ++i) {
    DatedValue value = dated(epochs[i], epochs[i].intersection.value, epochs[i].intersection.sigma);
    constexpr double least = 1e-3;  // of u: a smaller difference of the sums of squares is rounding
    value.apart = std::min(value.u, std::max(least * value.u, std::sqrt(std::max(0.0, own[i]))));
    value.least = std::min(value.apart, epochs[i].ofFit.sigma);
    value.expanded = epochs[i].intersection.expanded;
    value.judgement = epochs[i].judgement;
    values.push_back(value);
  }
  History history = historyOf(std::move(values), std::sqrt(shared), epochs.back().coverage);
  history.tolerance = toleranceOf(epochs);
  return history;
}

void setBaseline(DeviceHistory& device, std::size_t sessions) {
  std::vector<double> days;
  for (const Epoch& epoch : device.epochs) days.push_back(epoch.day);
  setBaseline(device.quantities, sessions, days);
}

std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t epochs) {
  constexpr std::size_t few = 20;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i + 1 < epochs; ++i)
    for (std::size_t j = i + 1; j < (epochs <= few ? epochs : i + 2); ++j) pairs.emplace_back(i, j);
  if (epochs > few) pairs.emplace_back(0, epochs - 1);
  return pairs;
}

DeviceHistories deviceHistories(const std::vector<Epoch>& epochs) {
  DeviceHistories histories;
  std::vector<std::string> keys;
  std::vector<std::vector<Epoch>> groups;
  std::vector<std::string> digests;
  for (const Epoch& epoch : epochs) digests.push_back(epoch.readings);
  const std::vector<std::size_t> firsts = firstsAlike(digests);
  for (std::size_t i = 0; i < epochs.size(); ++i) {
    if (firsts[i] != i) {
      histories.copies.emplace_back(i, firsts[i]);
      continue;
    }
    if (epochs[i].date.empty()) {
      histories.undated.push_back(i);
      continue;
    }
    const std::string key =
        epochs[i].deviceSerial.empty() ? "n" + epochs[i].device : "s" + epochs[i].deviceSerial;
    const auto group = static_cast<std::size_t>(std::ranges::find(keys, key) - keys.begin());
    if (group == keys.size()) {
      keys.push_back(key);
      groups.emplace_back();
    }
    groups[group].push_back(epochs[i]);
  }
  for (std::vector<Epoch>& group : groups) histories.devices.push_back(historyOfDevice(std::move(group)));
  return histories;
}

}  // namespace alidade
