#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>

#include "core/diagnosis/gap/leftover.h"

namespace alidade {

/// A vector over the readings with cached intermediate sums, for the inner products with the columns of many
/// components. Not thread-safe.
class SharedProducts {
 public:
  /// `vector` has `rows()` or `readings()` entries. Vector and leftover must outlive this object.
  SharedProducts(const Leftover& leftover, const Eigen::VectorXd& vector)
      : m_leftover(leftover), m_vector(vector) {}
  SharedProducts(const SharedProducts&) = delete;
  SharedProducts& operator=(const SharedProducts&) = delete;

  const Leftover& leftover() const { return m_leftover; }
  const Eigen::VectorXd& vector() const { return m_vector; }
  auto ofReadings() const { return m_vector.head(m_leftover.readings()); }
  /// Inner products with ∂reading/∂term of every term, as `Leftover::productsOfTerms` returns them.
  const Eigen::VectorXd& ofTerms() const {
    if (!m_ofTerms) m_ofTerms = m_leftover.productsOfTerms(m_vector);
    return *m_ofTerms;
  }
  /// Returns the result of `make`, which is called once for each `owner`.
  template <typename Make>
  const Eigen::VectorXd& once(const void* owner, const Make& make) const {
    const auto found = m_made.find(owner);
    return found != m_made.end() ? found->second : m_made.emplace(owner, make()).first->second;
  }

 private:
  const Leftover& m_leftover;
  const Eigen::VectorXd& m_vector;
  mutable std::optional<Eigen::VectorXd> m_ofTerms;
  mutable std::map<const void*, Eigen::VectorXd> m_made;
};

}  // namespace alidade
