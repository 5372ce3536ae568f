// See session_state.h.
#include "editor/session/session_state.h"

#include "brushes/symmetry.h"
#include "brushes/tile_rects.h"
#include "editor/session/mesh_hash.h"

namespace relievo {
namespace {

// Parts of the time that opening takes, about.
constexpr double kMeshRead = 0.05, kMapRead = 0.35, kSurfaceMade = 0.45, kMaskRead = 0.5;

// Empty where the heights are a map. Throws where the mesh reaches too far over the exemplar.
std::shared_ptr<const ProceduralSource> source_of(const Mesh& mesh, const Displacement& displacement,
                                                  const HeightMap& exemplar) {
    if (!displacement.procedural) return nullptr;
    auto source = std::make_shared<ProceduralSource>(*displacement.procedural, exemplar.width(),
                                                     exemplar.height(), exemplar.texels().data());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) source->texels_at(corner_uvs(mesh, face));
    return source;
}

}  // namespace

Session::State::State(const fs::path& scene_file, const SessionOptions& given)
    : options(given),
      scene(open_scene(scene_file, options.method, options.parameters)),
      start_map(options.map.empty() ? displacement().map : options.map),
      file(open_map(displacement(), start_map, traced_by(), within(options.opening, kMeshRead, kMapRead))),
      source(source_of(scene.objects.front().mesh, displacement(), file.map)),
      colours(options.colour_map.empty() ? albedo_map() : options.colour_map, albedo_map(),
              options.with_renderer) {
    if (source && !options.map.empty())
        throw std::invalid_argument(
            options.map.string() +
            ": the scene's heights are procedural; there is no map to put this in place of");
    opened(kMapRead);
    make_surface();
    brush.radius = scene.objects.front().mesh.sphere_radius * 0.1f;
    if (!displacement().map.empty()) map_path = displacement().map;
    starts_as_file = options.map.empty();
    const bool recording = !options.journal.empty() || options.recovery;
    header.version = std::string(RELIEVO_VERSION);
    header.scene = scene.path;
    header.map_width = file.map.width();
    header.map_height = file.map.height();
    header.midlevel = displacement().midlevel;
    header.amplitude = displacement().amplitude;
    header.undo_budget = options.undo_budget;
    header.mesh_hash = mesh_hash(scene.objects.front().mesh);
    if (recording) header.map_hash = file.map.hash();  // 512 MiB of texels take a while
    if (colours.there()) header.colour_map = fs::absolute(colours.start_file());
    if (recording && colours.there()) header.colour_hash = colours.map().hash();
    opened(kSurfaceMade);
    load_start_mask();
    if (!start_mask.empty()) header.mask = fs::absolute(start_mask);
    if (recording && sculptor->mask()) header.mask_hash = sculptor->mask()->hash();
    if (options.with_renderer) open_view();
    options.opening = nullptr;  // it is the opener's
    recorder = std::make_unique<Recorder>(header, options.journal, options.recovery);
    recorder->set_start_files({start_map, options.map.empty()},
                              {colours.start_file(), options.colour_map.empty()}, {start_mask, options.mask.empty()});
}

void Session::State::open_view() {
    others.reserve(scene.objects.size());
    for (std::size_t i = 1; i < scene.objects.size(); ++i) {
        const Displacement& other = scene.objects[i].displacement;
        others.push_back(open_map(other, other.map, traced_by()));
        other_sources.push_back(source_of(scene.objects[i].mesh, other, others.back().map));
    }
    opened(kMaskRead);
    std::vector<vulkan::Pass> ready;
    if (options.for_window) ready = {vulkan::Pass::beauty, vulkan::Pass::pick};
    if (options.for_window && sculptor->mask()) ready.push_back(vulkan::Pass::aov);  // what lies under it
    view = std::make_unique<SessionView>(scene, maps(), colours.view(), options, ready, within(options.opening, kMaskRead, 1));
}

std::vector<const HeightMap*> Session::State::maps() const {
    std::vector<const HeightMap*> all{&file.map};
    for (const LoadedMap& other : others) all.push_back(&other.map);
    return all;
}

void Session::State::take_heights(const Displacement& wanted, std::optional<LoadedMap> fresh, const Advance& advance) {
    SceneObject& object = scene.objects.front();
    const HeightMap& map = fresh ? fresh->map : file.map;
    auto made = source_of(object.mesh, wanted, map);
    if (view) view->set_heights({wanted, map}, {displacement(), file.map}, advance);  // whose texels stay where they are
    object.displacement = wanted;
    source = std::move(made);
    if (fresh) {
        symmetric.reset();
        sculptor.reset();
        surface.reset();
        file = std::move(*fresh);
        make_surface();
    }
    ++revision;
}

void Session::State::make_surface() {
    surface.emplace(scene.objects.front().mesh, displacement(), file.map);
    glm::dmat4 rebased(1.0);
    rebased[3] = glm::dvec4(-scene.origin, 1.0);
    surface->set_world_from_object(rebased * scene.objects.front().transform);
    sculptor.emplace(file.map, *surface, options.undo_budget);
    can_paint = false;
}

void Session::State::load_start_mask() {
    const auto load = [&](const fs::path& path) {
        sculptor->set_mask(load_mask(path, file.map.width(), file.map.height(),
                                     within(options.opening, kSurfaceMade, kMaskRead)));
        start_mask = path;
    };
    if (!options.mask.empty()) return load(options.mask);
    const fs::path beside = mask_path_beside(displacement().map);
    std::error_code ignored;
    if (!options.find_mask || displacement().map.empty() || !options.map.empty() || !fs::exists(beside, ignored)) return;
    try {
        load(beside);
    } catch (const std::invalid_argument& trouble) {  // the map is the work, and opens without
        scene.warnings.push_back(std::string(trouble.what()) + "; opened without a mask");
    }
}

void Session::State::allow_painting() {
    if (!colours.there() || can_paint) return;
    sculptor->set_colours(colours.map());
    can_paint = true;
}

void Session::State::show_edits() {
    if (unshown.empty() && unshown_colours.empty()) return;
    const TileGrid grid(file.map.width(), file.map.height());
    const auto take = [&](std::vector<TexelRect>& rects) { return without_overlaps(std::exchange(rects, {}), grid); };
    view->upload(file.map, take(unshown), times);
    view->upload_colours(colours.view(), take(unshown_colours), times);
}

const SymmetricDabs& Session::State::symmetry() {
    if (!symmetric)
        symmetric.emplace(scene.objects.front().mesh, *surface,
                          symmetry_copies(stroke.brush, surface->world_from_object()));
    return *symmetric;
}

}  // namespace relievo
