#pragma once

#include <optional>
#include <string>

#include "core/evaluation/guide.h"
#include "core/guidance/outlook.h"
#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The progress of a session in its protocol, with the findings on it.
struct Guidance : Guide {
  std::optional<double> uncertainty = {};    ///< U of Δd, mm
  std::optional<SightingsAhead> ahead = {};  ///< in a protocol by worth: needed for `uncertainty`
  Outlook outlook = {};
};

/// Fits and diagnoses the session. Returns the progress alone if the session contains nothing that can be
/// fitted. `uncertainty`: the intended U of Δd, mm, in a protocol by worth.
Guidance guidanceOf(const Session& session, SightingProtocol protocol,
                    std::optional<double> uncertainty = {});

/// Returns one JSON document.
std::string guidanceJson(const std::string& session, const Guidance& guidance,
                         const std::string& digest = {});

}  // namespace alidade
