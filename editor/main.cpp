// The program: the command line, with the window behind its verb `edit`.
#include <csignal>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "editor/cli/cli.h"

#ifdef RELIEVO_HAS_WINDOW
#include "editor/gui/editor.h"
#endif

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write, not the end of the session
    relievo::EditorEntry editor;
#ifdef RELIEVO_HAS_WINDOW
    editor = [](const relievo::EditRequest& request) {
#ifdef __GLIBC__
        // What a dab or a frame needs for a moment is kept for the next one: pages from the system cost more than the work
        // in them, on virtual machines most of all (microseconds each). App::give_memory_back() returns it between strokes.
        mallopt(M_MMAP_THRESHOLD, 32 << 20);  // as much as glibc takes
        mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
        return relievo::run_editor(
            relievo::EditorOptions{request.scene, request.frame_log, request.most_fps, request.session});
    };
#endif
    return relievo::run_cli(argc, argv, editor);
}
