#pragma once

namespace alidade {

/// Makes the allocator keep freed memory: returning the pages of long vectors to the system slows an
/// evaluation of 10⁵ rows by a sixth. Called once when a program starts.
void keepFreedMemory();

}  // namespace alidade
