#pragma once

#include <string_view>

namespace scree::test {

// What a fuzzer, or the test that replays its corpus, does with any bytes. Each ends the program when an
// error is not the one line that it should be; crashes and hangs show by themselves.

/// Bytes as a scene: parsed, and when it is one of few bodies without meshes, made and described.
void try_scene(std::string_view bytes);

/// Bytes as a mesh file, of a kind by the first of them: loaded, and described when it is one.
void try_mesh(std::string_view bytes);

/// Bytes as a checkpoint, as the contents of one whose checksum is right, and as changes to the state of a
/// run, which is then restored from it.
void try_checkpoint(std::string_view bytes);

}  // namespace scree::test
