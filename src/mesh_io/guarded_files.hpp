#pragma once

#include <string>

#include <assimp/IOSystem.hpp>

namespace scree {

/// How assimp gets at files: for reading only, regular files of bounded size only. Some of its importers ask
/// a file that ends too early for more, for ever; here that throws after a while, and the importer gives up.
class GuardedFiles : public Assimp::IOSystem {
  public:
    [[nodiscard]] bool Exists(const char* file) const override;
    [[nodiscard]] char getOsSeparator() const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// Why a file cannot be opened; empty if it can.
    static std::string obstacle(const std::string& file);
};

}  // namespace scree
