#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/document/half_typed.h"

namespace alidade::ui {

/// What is half typed beside a record of unsaved changes. A file of its own, so that a key costs no copy of
/// the session.
struct HalfTypedRecord {
  QString of;  ///< `RecoveryRecord::id` of the session that it is typed into
  std::vector<HalfTypedText> texts;

  bool operator==(const HalfTypedRecord&) const = default;
};

std::string halfTypedRecordText(const HalfTypedRecord& record);

/// The sentence where the bytes are no such record.
Result<HalfTypedRecord> readHalfTypedRecord(const std::string& bytes);

}  // namespace alidade::ui
