#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/document/half_typed.h"

namespace alidade::ui {

/// Unfinished entries that accompany a record of unsaved changes. They have a separate file, so that a
/// keystroke does not write the session again.
struct HalfTypedRecord {
  QString of;  ///< `RecoveryRecord::id` of the session being typed into
  std::vector<HalfTypedText> texts;

  bool operator==(const HalfTypedRecord&) const = default;
};

std::string halfTypedRecordText(const HalfTypedRecord& record);

/// Returns a problem if the bytes are not a `halfTypedRecordText`.
Result<HalfTypedRecord> readHalfTypedRecord(const std::string& bytes);

}  // namespace alidade::ui
