#pragma once

#include <Eigen/Core>
#include <array>

#include "core/adjustment/numerics/auto_diff.h"
#include "core/observation/observe.h"

namespace alidade {

// All quantities on which the readings of one arc depend, with derivatives, for joint_problem.cpp. A reading
// is modelled in two stages, and so are its derivatives: the guideway places the target, the instrument reads
// it. Each stage has derivatives with respect to its own quantities; the chain rule joins them. Jets have a
// fixed size, which the compiler unrolls.

/// Rounds up to an even size, with which jets are faster.
constexpr int evenSize(int slots) {
  return slots + slots % 2;
}

/// The error terms that have derivatives.
enum class ArcTerms { None, OfGuideway, All, AlsoOwn };  // `All`: of the catalogue and jumps

template <ArcTerms which>
struct ArcJets {
  /// Slots: x, y, R, slider zero, L, φ, then the terms from `firstGuidewayTerm` on, the user's own last.
  static constexpr int xSlot = 0, ySlot = 1, radiusSlot = 2, sliderSlot = 3, farSlot = 4, angleSlot = 5,
                       guidewayTermSlot = 6;
  /// Slots: the target's x, y, z, then the terms before `firstGuidewayTerm`, the user's own last.
  static constexpr int instrumentTermSlot = 3;
  static constexpr int ownSlots = which == ArcTerms::AlsoOwn ? static_cast<int>(mostOwnTerms) : 0;
  static constexpr int guidewaySlots =
      guidewayTermSlot + ownSlots +
      (which == ArcTerms::None ? 0 : static_cast<int>(firstOwnTerm - firstGuidewayTerm));
  static constexpr int instrumentSlots =
      instrumentTermSlot + ownSlots +
      (which == ArcTerms::All || which == ArcTerms::AlsoOwn ? static_cast<int>(firstGuidewayTerm) : 0);
  using GuidewayJet = Eigen::AutoDiffScalar<Eigen::Vector<double, evenSize(guidewaySlots)>>;
  using InstrumentJet = Eigen::AutoDiffScalar<Eigen::Vector<double, evenSize(instrumentSlots)>>;

  ErrorTerms<GuidewayJet> guidewayErrors{constant<GuidewayJet>(0)};
  ErrorTerms<InstrumentJet> instrumentErrors{constant<InstrumentJet>(0)};
  ArcPose<GuidewayJet> pose{constant<GuidewayJet>(0), constant<GuidewayJet>(0), constant<GuidewayJet>(0),
                            constant<GuidewayJet>(0), constant<GuidewayJet>(0), constant<GuidewayJet>(0)};
  GuidewayJet distance = constant<GuidewayJet>(0);
  /// The effect of the instrument's errors on the pointing zero, as its circles read it.
  Direction<InstrumentJet> zero{constant<InstrumentJet>(0), constant<InstrumentJet>(0)};
  double horizontalZero = 0;  ///< error of α0
  double zeroElevation = 0;   ///< e0 without the errors of the instrument and of β0

  template <typename Jet>
  static Jet constant(double value) {
    return Jet(value, Jet::DerType::Zero());
  }
  template <typename Jet>
  static Jet variable(double value, int slot) {
    return Jet(value, static_cast<int>(Jet::DerType::SizeAtCompileTime), slot);
  }

  /// The slot of a term in the jets of its own stage.
  static constexpr int slotOf(ErrorTerm term) {
    const auto index = static_cast<std::size_t>(term);
    if (isOfGuideway(term)) return guidewayTermSlot + static_cast<int>(index - firstGuidewayTerm);
    return instrumentTermSlot +
           static_cast<int>(isOwn(term) ? firstGuidewayTerm + (index - firstOwnInstrumentTerm) : index);
  }

  void set(ErrorTerm term, double size) {
    if (isOfGuideway(term))
      guidewayErrors.set(term, variable<GuidewayJet>(size, slotOf(term)));
    else
      instrumentErrors.set(term, variable<InstrumentJet>(size, slotOf(term)));
  }

  /// The target as input of the instrument's stage.
  static SpacePoint<InstrumentJet> asTarget(double x, double y, double z) {
    return {variable<InstrumentJet>(x, 0), variable<InstrumentJet>(y, 1), variable<InstrumentJet>(z, 2)};
  }
};

}  // namespace alidade
