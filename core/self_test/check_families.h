#pragma once

#include <string>
#include <vector>

#include "core/self_test/self_check.h"

namespace alidade {

// The checks of each family of the self-test. `fits` and `numbers` are those of `SelfTestReferences`.

/// Sessions fitted at 60 digits by another implementation: centre, radius and χ² of each arc, Δd and its σ.
std::vector<SelfCheck> fitChecks(const std::string& fits);

/// The figures printed in the paper for its own measurement, by the published method.
std::vector<SelfCheck> publishedChecks();

/// Diagnoses of samples with a known truth: the verdict, the cause and its size.
std::vector<SelfCheck> diagnosisChecks();

/// Student's t, χ², F and normal distributions at 50 digits, and the table of JCGM 100.
std::vector<SelfCheck> distributionChecks(const std::string& numbers);

/// Texts of angles, as radians and arcseconds.
std::vector<SelfCheck> angleChecks(const std::string& numbers);

/// Random numbers of some seeds, and a simulated session.
std::vector<SelfCheck> randomChecks(const std::string& numbers);

/// The installed files next to the programs, by their SHA-256.
std::vector<SelfCheck> installedChecks(const std::string& share);

}  // namespace alidade
