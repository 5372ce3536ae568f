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
        // What a large dab needed for a moment goes back to the system; by itself, glibc comes to keep it.
        // Other verbs are over soon, and a replay of large dabs would spend a sixth of its time on it.
        mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
        return relievo::run_editor(
            relievo::EditorOptions{request.scene, request.frame_log, request.most_fps, request.session});
    };
#endif
    return relievo::run_cli(argc, argv, editor);
}
