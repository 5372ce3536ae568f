# Sourced by run.sh and test.sh: what the project needs from the system, found or installed (apt, quiet, only when
# missing). Debian 12's own Mesa has no ray tracing: then mesa-vulkan-drivers comes from the backports suite, whose
# entry is derived from the machine's own Debian source entry.

# "package probe": the probe (cmd: a command, file: a path below an include or library folder) answers where there
# is no package database.
relievo_build_packages=(
    "g++ cmd:g++" "cmake cmd:cmake" "ninja-build cmd:ninja" "pkg-config cmd:pkg-config" "ccache cmd:ccache"
    "glslang-tools cmd:glslangValidator"
    "libvulkan-dev file:vulkan/vulkan.h" "libglfw3-dev file:GLFW/glfw3.h" "libimgui-dev file:imgui/imgui.h"
    "spirv-headers file:spirv/unified1/spirv.hpp" "libxi-dev file:X11/extensions/XInput2.h"
    "libglm-dev file:glm/glm.hpp" "libopenimageio-dev file:OpenImageIO/imageio.h"
    "openimageio-tools cmd:iconvert"  # named by the CMake files of libopenimageio-dev
    "python3-imath file:Imath/half.h" "libopenmesh-dev file:OpenMesh/Core/System/config.h"
    "nlohmann-json3-dev file:nlohmann/json.hpp" "libcli11-dev file:CLI/CLI.hpp" "libeigen3-dev file:eigen3/Eigen/Core"
    "libtbb-dev file:oneapi/tbb.h"
)
relievo_test_packages=(
    "libgtest-dev file:gtest/gtest.h" "libbenchmark-dev file:benchmark/benchmark.h"
    "vulkan-validationlayers file:libVkLayer_khronos_validation.so" "xvfb cmd:Xvfb" "xdotool cmd:xdotool"
    "python3 cmd:python3" "git cmd:git"
)
relievo_driver_version=24  # Mesa with ray tracing in its CPU driver

relievo_has() {  # "package probe"
    local package=${1%% *} probe=${1##* }
    if command -v dpkg-query >/dev/null 2>&1; then
        grep -qx "$package" <<<"$relievo_installed"
        return
    fi
    case $probe in
        cmd:*) command -v "${probe#cmd:}" >/dev/null 2>&1 ;;
        file:*)
            local folder
            for folder in /usr/include /usr/local/include /usr/lib /usr/lib64 /usr/lib/*-linux-gnu /usr/local/lib; do
                [ -e "$folder/${probe#file:}" ] && return 0
            done
            return 1
            ;;
    esac
}

# A Vulkan driver with ray tracing: any hardware driver counts, else Mesa of the right version.
relievo_has_driver() {
    if command -v dpkg-query >/dev/null 2>&1; then
        local version
        version=$(dpkg-query -W -f='${db:Status-Status} ${Version}' mesa-vulkan-drivers 2>/dev/null) || return 1
        case $version in installed\ *) ;; *) return 1 ;; esac
        version=${version#installed }
        version=${version#*:}
        [ "${version%%.*}" -ge "$relievo_driver_version" ] 2>/dev/null
        return
    fi
    ls /usr/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json >/dev/null 2>&1
}

relievo_candidate_driver() { apt-cache policy mesa-vulkan-drivers 2>/dev/null | sed -n 's/^ *Candidate: *\([0-9]*:\)\{0,1\}\([0-9]*\).*/\2/p'; }

# Writes /etc/apt/sources.list.d/relievo-backports.* from the entry that brings this release's main suite.
relievo_add_backports() {
    local codename file
    codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
    [ -n "$codename" ] || { echo "relievo: /etc/os-release names no release; add its backports suite by hand" >&2; return 1; }
    if grep -rqsE "(^Suites:.*|^deb .*)\b$codename-backports\b" /etc/apt/sources.list /etc/apt/sources.list.d/; then return 0; fi
    for file in /etc/apt/sources.list.d/*.sources; do
        [ -e "$file" ] || continue
        # The first paragraph (deb822) whose suites hold the release itself, with its suites replaced.
        awk -v name="$codename" 'BEGIN { RS = ""; FS = "\n" }
            { hit = 0; for (i = 1; i <= NF; i++) if ($i ~ /^Suites:/) { n = split($i, w, /[ \t]+/); for (k = 2; k <= n; k++) if (w[k] == name) hit = 1 }
              if (hit) { for (i = 1; i <= NF; i++) { if ($i ~ /^#/) continue; if ($i ~ /^Suites:/) $i = "Suites: " name "-backports"; print $i }; exit } }' \
            "$file" >/tmp/relievo-backports.$$
        if [ -s /tmp/relievo-backports.$$ ]; then
            mv /tmp/relievo-backports.$$ /etc/apt/sources.list.d/relievo-backports.sources
            chmod 644 /etc/apt/sources.list.d/relievo-backports.sources
            return 0
        fi
    done
    rm -f /tmp/relievo-backports.$$
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -e "$file" ] || continue
        local line
        line=$(grep -E "^deb .*[ ]$codename[ ]" "$file" | head -n 1)
        [ -n "$line" ] || continue
        echo "${line/ $codename / $codename-backports }" >/etc/apt/sources.list.d/relievo-backports.list
        return 0
    done
    echo "relievo: no Debian source entry for $codename was found; mesa-vulkan-drivers $relievo_driver_version or newer must be installed by hand" >&2
    return 1
}

# relievo_install NAME...: arrays of wanted packages. Installs what is missing, or says what is.
relievo_install() {
    local missing=() entry array driver=yes
    relievo_installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p')
    for array in "$@"; do
        local -n wanted=$array
        for entry in "${wanted[@]}"; do relievo_has "$entry" || missing+=("${entry%% *}"); done
    done
    relievo_has_driver || driver=no
    [ ${#missing[@]} -eq 0 ] && [ $driver = yes ] && return 0
    local all="${missing[*]}"
    [ $driver = yes ] || all="${all:+$all }mesa-vulkan-drivers (version $relievo_driver_version or newer)"
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "relievo: there is no apt here; these packages (by their Debian names) are missing: $all" >&2
        return 1
    fi
    if [ "$(id -u)" != 0 ]; then
        echo "relievo: these packages are missing, and installing them needs root: $all" >&2
        echo "relievo: run this script once as root, or install them yourself" >&2
        return 1
    fi
    echo "relievo: installing $all" >&2
    local log
    log=$(mktemp)
    if ! {
        export DEBIAN_FRONTEND=noninteractive
        apt-get update -qq &&
            { [ ${#missing[@]} -eq 0 ] || apt-get install -y -qq --no-install-recommends "${missing[@]}"; } &&
            if [ $driver = no ]; then
                if [ "$(relievo_candidate_driver)" -ge "$relievo_driver_version" ] 2>/dev/null; then
                    apt-get install -y -qq --no-install-recommends mesa-vulkan-drivers
                else
                    relievo_add_backports && apt-get update -qq &&
                        apt-get install -y -qq --no-install-recommends -t "$(. /etc/os-release && echo "$VERSION_CODENAME")-backports" mesa-vulkan-drivers
                fi
            fi
    } >"$log" 2>&1; then
        echo "relievo: installing packages failed; apt's last words:" >&2
        tail -n 15 "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}
