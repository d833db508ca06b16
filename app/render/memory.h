#pragma once

namespace app {

// For the whole process: what is freed stays at hand. A driver that draws with the processor asks for some
// megabytes in each frame; to give them back to the system and take them anew costs about as much as the drawing.
void keep_freed_memory();

}  // namespace app
