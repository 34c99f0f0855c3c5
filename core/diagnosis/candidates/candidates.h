#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/result/noise_policy.h"

namespace alidade {

/// Prior odds of each kind of component against "no gap at all". They are rough: a factor of two in any of
/// them changes no clear answer.
struct PriorOdds {
  double effect = 0.04;      ///< for each effect
  double jump = 0.04;        ///< for all moments together
  double wrongZero = 0.04;   ///< for a jump between a zero and the first visit, all positions together
  double grossError = 0.08;  ///< for all readings together
  double noise = noise_policy::odds;  ///< for noise larger than stated
  double shape = 0.04;                ///< for all patterns together
};

/// States how many components of one kind the search may add to a set.
struct Offer {
  std::size_t offered = 0;  ///< number of components of largest gain that are offered; 0: all
  bool oneAtMost = false;   ///< a set holds at most one component of the kinds with this flag
};

/// All components that an explanation may contain, numbered consecutively.
class Candidates {
 public:
  /// Consecutive components of one kind.
  struct Group : Offer {
    std::size_t first = 0, count = 0;
    double logPrior = 0;  ///< natural logarithm of the prior odds of one component against no gap

    bool has(std::size_t component) const { return component >= first && component - first < count; }
  };

  /// `odds` are the prior odds of one component; `Kind` is a final class. `Offer::offered` works only for
  /// components of one or two columns.
  template <typename Kind>
  void add(std::vector<Kind> components, double odds, Offer offer = {}) {
    if (components.empty()) return;
    m_groups.push_back({offer, size(), components.size(), std::log(odds)});
    m_blocks.push_back(std::make_shared<const BlockOf<Kind>>(std::move(components)));
  }

  std::size_t size() const { return m_groups.empty() ? 0 : m_groups.back().first + m_groups.back().count; }
  const Component& operator[](std::size_t component) const {
    const std::size_t group = groupIndex(component);
    return (*m_blocks[group])[component - m_groups[group].first];
  }
  std::span<const Group> groups() const { return m_groups; }
  const Group& groupOf(std::size_t component) const { return m_groups[groupIndex(component)]; }
  /// Returns whether gross errors are among the candidates.
  bool haveGrossErrors() const;
  /// Fills `all` with the inner products of all visible columns, in order, with a visible vector.
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> all) const;

 private:
  /// Components of one kind, stored by value: one virtual call fills the inner products of all of them.
  struct Block {
    virtual ~Block() = default;
    virtual const Component& operator[](std::size_t i) const = 0;
    /// Fills the first entries of `rest`, one for each visible column of the block. Returns their number.
    virtual Eigen::Index fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> rest) const = 0;
  };
  template <typename Kind>
  struct BlockOf final : Block {
    std::vector<Kind> components;

    explicit BlockOf(std::vector<Kind> all) : components(std::move(all)) {}
    const Component& operator[](std::size_t i) const override { return components[i]; }
    Eigen::Index fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> rest) const override {
      Eigen::Index first = 0;
      for (const Kind& component : components) {
        const Eigen::Index count = component.gram().cols();
        component.fillProducts(with, rest.segment(first, count));
        first += count;
      }
      return first;
    }
  };

  std::vector<Group> m_groups;
  std::vector<std::shared_ptr<const Block>> m_blocks;

  std::size_t groupIndex(std::size_t component) const {
    std::size_t group = 0;
    while (!m_groups[group].has(component)) ++group;
    return group;
  }
};

}  // namespace alidade
