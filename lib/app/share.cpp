#include "app/share.hpp"

#include <filesystem>

#include "core/error.hpp"

namespace ifedem {

std::string share_directory() {
    namespace fs = std::filesystem;
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    for (const fs::path& place : {program.parent_path().parent_path() / "share" / "ifedem", fs::path(IFEDEM_REPORTS)}) {
        if (fs::exists(place / "style.gp")) return place.string();
    }
    fail_io("style.gp is missing (the program was moved without share/ifedem). Install it by cmake --install?");
}

}  // namespace ifedem
