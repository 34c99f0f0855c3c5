#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/result/noise_policy.h"

namespace alidade {

/// What is believed before the readings are seen, in odds against "no gap at all". Broad on purpose: a factor
/// of two in any of them moves no clear answer.
struct PriorOdds {
  double effect = 0.04;               ///< each
  double jump = 0.04;                 ///< shared by all moments
  double zeroSlip = 0.04;             ///< a jump between a zero and the first place; shared by the positions
  double grossError = 0.08;           ///< shared by all readings
  double noise = noise_policy::odds;  ///< larger than stated
  double shape = 0.04;                ///< shared by all shapes
};

/// How components of one kind are offered to a set that takes one more.
struct Offer {
  std::size_t offered = 0;  ///< only so many of them, the best; 0: each
  bool oneAtMost = false;   ///< in a set, of all kinds that say so
};

/// The components that an explanation may be made of, numbered through.
class Candidates {
 public:
  /// Those of one kind, one after the other.
  struct Group : Offer {
    std::size_t first = 0, count = 0;
    double logPrior = 0;  ///< of each: natural, odds against nothing at all

    bool has(std::size_t component) const { return component >= first && component - first < count; }
  };

  /// `odds`: of each. `Kind`: a final class. Only those of one column each, or of two, can be offered in
  /// part.
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
  /// Readings may be off.
  bool haveGrossErrors() const;
  /// The inner products of the visible columns of all, in their order, with a vector that is visible.
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> all) const;

 private:
  /// Components by value, so that what is there for every reading costs a few bytes and no call each.
  struct Block {
    virtual ~Block() = default;
    virtual const Component& operator[](std::size_t i) const = 0;
    /// Returns how many columns it has.
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
