"""VTK 9 with people in its picture (samples/hosts/vtk): claque names what VTK leaves bound and draws nothing; with the
way round both draw, and VTK finds its state. Prints what it saw; fails with the first thing that is not so.

    vtk_check.py PICTURE.png
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "samples/hosts/vtk"))
import claque
import people
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter


def pixels(window):
    data = people.picture(window)
    return vtk_to_numpy(data.GetPointData().GetScalars()).reshape(people.HEIGHT, people.WIDTH, 3).copy()


def render(window):
    window.Render()
    return pixels(window)


def sign_of(picture):
    """What VTK draws after people; row 0 is the lowest."""
    left, bottom, right, top = people.SIGN
    return picture[int(bottom * people.HEIGHT):int(top * people.HEIGHT),
                   int(left * people.WIDTH):int(right * people.WIDTH)]


def refusals(target, window, guest):
    """What claque names, one after the other: each is taken away when it has been named."""
    gl = target.gl
    away = {"GL_ARRAY_BUFFER": lambda: gl.glBindBuffer(people.ARRAY_BUFFER, 0),
            "GL_ELEMENT_ARRAY_BUFFER": lambda: gl.glBindBuffer(people.ELEMENT_ARRAY_BUFFER, 0),
            "the active texture unit is not 0": lambda: window.GetState().vtkglActiveTexture(people.TEXTURE0),
            "a program is in use": lambda: window.GetShaderCache().ReleaseCurrentShader()}
    named = []

    def unbind(_window):
        for name in named:
            away[name]()

    guest.unbind = unbind
    while True:
        window.Render()
        if not guest.failure:
            return named
        found = [name for name in away if guest.failure.endswith(name)]
        assert len(found) == 1 and found[0] not in named, guest.failure
        named += found


def check_people(target, renderer, window, context):
    citizen = claque.Template.builtin(context, "citizen", levels=True)
    with claque.Crowd(context) as crowd, claque.Renderer(context, target) as drawer:
        drawer.prepare(citizen)
        people.populate(crowd, citizen)
        target.light()
        alone = render(window)
        guest = people.Guest(target, crowd, drawer)
        guest.unbinds = False
        observer = renderer.AddObserver("EndEvent", guest.draw)
        refused = render(window)
        assert guest.failure, "claque draws with what VTK leaves bound"
        assert (refused == alone).all(), "a picture changes although claque refuses"

        guest.unbinds = True
        together = render(window)
        assert guest.drawn > 30, f"{guest.drawn} people: {guest.failure}"
        changed = (together != alone).any(axis=2).mean()
        assert 0.05 < changed < 0.4, f"people are in {100 * changed:.1f} % of the picture"
        assert (sign_of(together) == sign_of(alone)).all(), "what VTK draws after people is another"
        assert (render(window) == together).all(), "another picture of the same time"
        writer = vtkPNGWriter()
        writer.SetFileName(sys.argv[1])
        writer.SetInputData(people.picture(window))
        writer.Write()

        named = refusals(target, window, guest)
        assert {"the active texture unit is not 0", "GL_ARRAY_BUFFER", "a program is in use"} <= set(named), named
        renderer.RemoveObserver(observer)
        assert (render(window) == alone).all(), "VTK does not find its state"
    citizen.close()
    return f"refused: {', '.join(named)}; then {guest.drawn} people in {100 * changed:.0f} % of the picture"


def main():
    target = people.GlutWindow()
    renderer = people.scenery()
    window = people.window_of(renderer)
    window.Render()
    with claque.Context() as context:
        print(check_people(target, renderer, window, context))


if __name__ == "__main__":
    main()
