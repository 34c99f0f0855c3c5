#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// Adds the `measurementResults`. `version`: of this program; `results`: `fitJson` of the answer.
void addMeasurementResults(const Element& certificate, const CertificateSource& source,
                           const std::string& version, const std::string& results);

// Parts of it:

/// Adds the methods, software, the theodolite with its certificate, and the conditions, in the order of the
/// schema.
void addMeasuring(const Element& result, const CertificateSource& source, const std::string& version);

/// Adds the decision rule, the tolerance and the statement, or why there is none, to `measurementMetaData`.
void addConformity(const Element& metaData, const CertificateSource& source);

/// The statement of conformity in the schema's words: `pass` for accept, `fail` for reject. If the verdict
/// has a condition, such as a cause or that the tripod was not knocked: `conditionalPass`, `conditionalFail`.
/// These also apply to an undecided verdict (ILAC-G8:09/2019, 4.2.3) if only U prevents a decision: the side
/// of the tolerance on which the value lies then decides. For Δd, the value of the fit only must lie on the
/// same side. In all other cases, and without a tolerance, there is no statement.
std::optional<std::string_view> conformityOf(const FitAnswer& answer);

}  // namespace alidade
