// The threads of a LiveReference. The first one builds the surface and answers questions; helpers join it for
// a picture. A job that was replaced or stopped is left at the next pixel.
#include "editor/session/reference_workers.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <utility>

namespace relievo {
namespace {

constexpr std::int64_t kNewsEveryMs = 120;
constexpr int kLessUrgent = 10;  // of nice: the interface and the device come first

void be_patient() {
    // On Linux this is the calling thread's own; elsewhere it may be refused, which does no harm.
    setpriority(PRIO_PROCESS, 0, kLessUrgent);
}

unsigned helper_count(unsigned threads) {
    if (threads > 0) return threads - 1;
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    return cores > 2 ? cores - 2 : 0;
}

}  // namespace

std::shared_ptr<const ReferenceSnapshot> take_snapshot(const Session& session) {
    auto snapshot = std::make_shared<ReferenceSnapshot>();
    const Scene& scene = session.scene();
    snapshot->revision = session.map_revision();
    snapshot->amplitude = scene.objects.front().displacement.amplitude;
    snapshot->midlevel = scene.objects.front().displacement.midlevel;
    const auto texels = session.map().texels();
    snapshot->texels.assign(texels.begin(), texels.end());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const HeightMap& map = session.map_of(i);
        const std::uint16_t* first = i == 0 ? snapshot->texels.data() : map.texels().data();
        snapshot->objects.push_back(reference_object(scene.objects[i], {map.width(), map.height(), first}));
        snapshot->opacity_paths.push_back(scene.objects[i].opacity_map);
    }
    return snapshot;
}

ReferenceWorkers::ReferenceWorkers(std::function<void()> on_news, unsigned threads)
    : on_news_(std::move(on_news)), helpers_(helper_count(threads)), thread_([this] { run(); }) {}

ReferenceWorkers::~ReferenceWorkers() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        ++job_number_;
    }
    wake_.notify_all();
    thread_.join();
}

// Coarse to fine, and each pass from the top.
std::vector<ReferenceWorkers::Place> ReferenceWorkers::places(int width, int height) {
    std::vector<Place> all;
    for (int step = ReferencePicture::kCoarsest; step > 0; step /= 2)
        for (int row = 0; row < height; row += step)
            if (ReferencePicture::first_column(step, row) < width) all.push_back({step, row});
    return all;
}

std::size_t ReferenceWorkers::start(ReferenceJob job) {
    const std::size_t count = places(job.width, job.height).size();
    {
        const std::lock_guard lock(mutex_);
        ++job_number_;
        strips_.clear();
        job_ = std::move(job);
    }
    wake_.notify_all();
    return count;
}

void ReferenceWorkers::stop() {
    const std::lock_guard lock(mutex_);
    ++job_number_;
    strips_.clear();
    job_.reset();
}

std::vector<ReferencePicture::Strip> ReferenceWorkers::take_strips() {
    const std::lock_guard lock(mutex_);
    return std::exchange(strips_, {});
}

void ReferenceWorkers::ask(std::shared_ptr<const ReferenceSnapshot> snapshot, const Ray& ray) {
    {
        const std::lock_guard lock(mutex_);
        question_ = Question{std::move(snapshot), ray};
        verdict_.reset();
        asked_ = true;
    }
    wake_.notify_all();
}

std::optional<ReferenceVerdict> ReferenceWorkers::take_verdict() {
    const std::lock_guard lock(mutex_);
    return std::exchange(verdict_, std::nullopt);
}

std::string ReferenceWorkers::take_trouble() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, {});
}

void ReferenceWorkers::report(const char* trouble) {
    {
        const std::lock_guard lock(mutex_);
        trouble_ = trouble;
    }
    on_news_();
}

void ReferenceWorkers::run() {
    be_patient();
    while (true) {
        std::optional<ReferenceJob> job;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return quit_ || job_ || question_; });
            if (quit_) return;
            if (!question_) {
                job = std::exchange(job_, std::nullopt);
                number = job_number_;
            }
        }
        try {
            if (job) {
                trace(*job, number);
            } else {
                answer_question(false);
            }
        } catch (const std::exception& trouble) {
            report(trouble.what());
        }
    }
}

void ReferenceWorkers::build(const std::shared_ptr<const ReferenceSnapshot>& snapshot) {
    if (built_.snapshot == snapshot && built_.surface) return;
    built_.surface.reset();
    built_.snapshot = snapshot;
    // Opacity maps are files that no edit changes: they are read once.
    if (built_.opacity.empty())
        for (const auto& path : snapshot->opacity_paths)
            built_.opacity.push_back(path.empty() ? OpacityMap{} : load_opacity_map(path));
    std::vector<ReferenceObject> objects = snapshot->objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const OpacityMap& opacity = built_.opacity[i];
        if (!snapshot->opacity_paths[i].empty())
            objects[i].opacity = {opacity.width, opacity.height, opacity.texels.data()};
    }
    built_.surface = std::make_unique<ReferenceSurface>(objects);
}

void ReferenceWorkers::trace(const ReferenceJob& job, std::uint64_t number) {
    build(job.snapshot);
    const std::vector<Place> all = places(job.width, job.height);
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> helpers;
    for (unsigned i = 0; i < helpers_; ++i)
        helpers.emplace_back([&] {
            be_patient();
            try {
                trace_places(job, number, all, next, false);
            } catch (const std::exception& trouble) {
                report(trouble.what());
            }
        });
    trace_places(job, number, all, next, true);
    for (std::thread& helper : helpers) helper.join();
    on_news_();
}

void ReferenceWorkers::trace_places(const ReferenceJob& job, std::uint64_t number,
                                    const std::vector<Place>& all, std::atomic<std::size_t>& next,
                                    bool answers) {
    for (std::size_t i = next++; i < all.size(); i = next++) {
        ReferencePicture::Strip strip{all[i].step, all[i].row, {}, {}};
        for (const int x : ReferencePicture::columns(job.width, strip.step, strip.row)) {
            if (job_number_ != number) return;
            if (answers && asked_) answer_question(true);
            const ReferenceRay ray =
                reference_camera_ray(job.camera, job.origin, job.width, job.height, x + 0.5, strip.row + 0.5);
            const auto hit =
                built_.surface->first_hit(ray.origin, ray.direction, 0, std::numeric_limits<double>::max());
            strip.depth.push_back(hit ? hit->t : std::numeric_limits<double>::infinity());
            strip.object.push_back(hit ? hit->object + 1 : 0);
        }
        {
            const std::lock_guard lock(mutex_);
            if (job_number_ != number) return;
            strips_.push_back(std::move(strip));
        }
        tell_of_strips();
    }
}

// Not of each: whoever hears of it draws a frame.
void ReferenceWorkers::tell_of_strips() {
    const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(
                         std::chrono::steady_clock::now().time_since_epoch())
                         .count();
    std::int64_t last = last_news_ms_;
    if (now - last >= kNewsEveryMs && last_news_ms_.compare_exchange_strong(last, now)) on_news_();
}

// In a picture's midst only where the question is about the same surface, which other threads read: a
// question about another one comes with the end of that job.
void ReferenceWorkers::answer_question(bool within_job) {
    std::optional<Question> question;
    {
        const std::lock_guard lock(mutex_);
        asked_ = false;
        if (within_job && question_ && question_->snapshot != built_.snapshot) return;
        question = std::exchange(question_, std::nullopt);
    }
    if (!question) return;
    build(question->snapshot);
    const glm::dvec3 origin(question->ray.origin), direction(question->ray.direction);
    const ReferenceAnswer answer =
        built_.surface->trace(origin, direction, 0, std::numeric_limits<double>::max());
    ReferenceVerdict verdict{answer.hit, {}, answer.undecided};
    if (answer.hit)
        verdict.point =
            built_.surface->evaluate(answer.hit->object, answer.hit->face, answer.hit->b1, answer.hit->b2);
    {
        const std::lock_guard lock(mutex_);
        if (!question_) verdict_ = verdict;
    }
    on_news_();
}

}  // namespace relievo
