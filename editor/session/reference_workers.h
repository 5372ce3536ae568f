// The threads of a LiveReference: they know no session, only snapshots of its surface.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "editor/session/live_reference.h"
#include "renderer/opacity.h"

namespace relievo {

// The surface at one moment. What edits never change is pointed to.
struct ReferenceSnapshot {
    std::uint64_t revision = 0;
    double amplitude = 0, midlevel = 0;  // of the edited object
    std::vector<std::uint16_t> texels;   // likewise
    std::vector<ReferenceObject> objects;
    std::vector<std::filesystem::path> opacity_paths;  // one an object, may be empty
};
std::shared_ptr<const ReferenceSnapshot> take_snapshot(const Session& session);

struct ReferenceJob {
    std::shared_ptr<const ReferenceSnapshot> snapshot;
    Camera camera;
    glm::dvec3 origin{0};
    int width = 0, height = 0;
};

class ReferenceWorkers {
  public:
    ReferenceWorkers(std::function<void()> on_news, unsigned threads);
    ~ReferenceWorkers();

    std::size_t start(ReferenceJob job);  // in place of the one under way; how many strips it will give
    void stop();
    std::vector<ReferencePicture::Strip> take_strips();  // of the last job started

    void ask(std::shared_ptr<const ReferenceSnapshot> snapshot, const Ray& ray);
    std::optional<ReferenceVerdict> take_verdict();
    std::string take_trouble();

  private:
    struct Question {
        std::shared_ptr<const ReferenceSnapshot> snapshot;
        Ray ray;
    };
    struct Place {
        int step, row;
    };
    // A surface over the snapshot that it reads.
    struct Built {
        std::shared_ptr<const ReferenceSnapshot> snapshot;
        std::vector<OpacityMap> opacity;
        std::unique_ptr<ReferenceSurface> surface;
    };
    static std::vector<Place> places(int width, int height);
    void run();
    void build(const std::shared_ptr<const ReferenceSnapshot>& snapshot);
    void trace(const ReferenceJob& job, std::uint64_t number);
    void trace_places(const ReferenceJob& job, std::uint64_t number, const std::vector<Place>& all,
                      std::atomic<std::size_t>& next, bool answers);
    void answer_question(bool within_job);
    void report(const char* trouble);
    void tell_of_strips();

    std::function<void()> on_news_;
    unsigned helpers_;  // beside the first thread, while a picture is traced
    Built built_;       // of the first thread
    std::atomic<std::uint64_t> job_number_{0};
    std::atomic<bool> asked_{false};
    std::atomic<std::int64_t> last_news_ms_{0};

    std::mutex mutex_;  // of all below
    std::condition_variable wake_;
    bool quit_ = false;
    std::optional<ReferenceJob> job_;
    std::optional<Question> question_;
    std::vector<ReferencePicture::Strip> strips_;
    std::optional<ReferenceVerdict> verdict_;
    std::string trouble_;

    std::thread thread_;
};

}  // namespace relievo
