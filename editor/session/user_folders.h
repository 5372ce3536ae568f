// Where a user's files go when nobody named a place: the XDG base directories.
#pragma once

#include <filesystem>

namespace relievo {

// $XDG_CONFIG_HOME/relievo, else ~/.config/relievo. Where there is no home, both are a folder of the
// temporary directory. None is created.
std::filesystem::path config_folder();

// $XDG_STATE_HOME/relievo, else ~/.local/state/relievo.
std::filesystem::path state_folder();

}  // namespace relievo
