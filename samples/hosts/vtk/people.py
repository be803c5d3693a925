"""People in a VTK 9 scene: VTK renders in a context of this program, and claque draws into VTK's picture.

    PYTHONPATH=lib/python CLAQUE_LIBRARY_DIR=... python3 samples/hosts/vtk/people.py PICTURE.png

VTK draws with shaders, in a compatibility context that GLUT makes: claque needs fixed functions. When a renderer of VTK
has drawn, its program and a buffer are still bound, and another texture unit may be active. claque refuses to draw
then, and names the first of these; `Guest.unbind` is the way round. VTK finds everything else as it left it.
"""

import ctypes
import ctypes.util
import random
import sys

import claque
from claque import abi
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkGenericOpenGLRenderWindow

WIDTH, HEIGHT = 960, 600
SIGN = (0.02, 0.74, 0.10, 0.98)  # left, bottom, right, top
EYE, AT, FOV_DEG, NEAR, FAR = (4.5, 3.0, 9.5), (0.0, 1.2, 0.0), 40.0, 0.5, 60.0
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, TEXTURE0 = 0x8892, 0x8893, 0x84C0
MODELVIEW, LIGHTING, LIGHT0, AMBIENT, DIFFUSE, POSITION = 0x1700, 0x0B50, 0x4000, 0x1200, 0x1201, 0x1203


class GlutWindow:
    """A window with a compatibility context, current on this thread; for claque.Renderer, a target."""

    def __init__(self):
        self.gl = ctypes.CDLL("libGL.so.1", mode=ctypes.RTLD_GLOBAL)
        self.gl.glXGetProcAddressARB.restype = ctypes.c_void_p
        self.glut = ctypes.CDLL(ctypes.util.find_library("glut"))
        self.glut.glutInit(ctypes.byref(ctypes.c_int(1)), (ctypes.c_char_p * 2)(b"people", None))
        self.glut.glutInitDisplayMode(2 | 16)  # double buffered, with depth
        self.glut.glutInitWindowSize(WIDTH, HEIGHT)
        self.glut.glutCreateWindow(b"people")
        self.get_proc_address = abi.GetProcAddress(lambda _user, name: self.gl.glXGetProcAddressARB(name))

    def light(self):
        """VTK's lights are its shaders' business: GL's own are claque's here."""
        self.gl.glEnable(LIGHTING)
        self.gl.glEnable(LIGHT0)
        self.gl.glMatrixMode(MODELVIEW)
        self.gl.glLoadIdentity()
        light = {AMBIENT: (0.4, 0.4, 0.42, 1), DIFFUSE: (0.7, 0.68, 0.64, 1), POSITION: (0.4, 0.7, 0.6, 0)}
        for name, values in light.items():
            self.gl.glLightfv(LIGHT0, name, (ctypes.c_float * 4)(*values))


class Guest:
    """A crowd that is drawn when a vtkRenderer ends, into the same picture and depth."""

    def __init__(self, target, crowd, renderer):
        self.target, self.crowd, self.renderer = target, crowd, renderer
        self.view = crowd.view()
        self.view.set_height(HEIGHT)
        self.time_s, self.unbinds, self.failure, self.drawn = 0.0, True, "", 0

    def unbind(self, window):
        """VTK keeps count of program and texture unit, so they are set through it. It binds buffers before each use."""
        window.GetShaderCache().ReleaseCurrentShader()
        window.GetState().vtkglActiveTexture(TEXTURE0)
        self.target.gl.glBindBuffer(ARRAY_BUFFER, 0)
        self.target.gl.glBindBuffer(ELEMENT_ARRAY_BUFFER, 0)

    def draw(self, renderer, _event):
        self.drawn, self.failure = 0, ""
        camera = renderer.GetActiveCamera()
        near, far = camera.GetClippingRange()
        try:
            self.view.look_at(camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp(),
                              camera.GetViewAngle() * 0.017453292519943, WIDTH / HEIGHT, near, far)
            self.crowd.update(self.time_s, self.view)
            if self.unbinds:
                self.unbind(renderer.GetRenderWindow())
            self.drawn = self.renderer.draw(self.view).individuals
        except abi.Error as failure:
            self.failure = str(failure)


def add(renderer, source, at, colour, opacity=1.0):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.SetPosition(*at)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetAmbient(0.4), actor.GetProperty().SetDiffuse(0.75)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)


def scenery():
    """A floor with columns, a beam and panes between them, and the camera."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.55, 0.68, 0.82)
    floor, column, beam, pane = vtkPlaneSource(), vtkCylinderSource(), vtkCubeSource(), vtkPlaneSource()
    floor.SetOrigin(-9, 0, 4.5), floor.SetPoint1(9, 0, 4.5), floor.SetPoint2(-9, 0, -4.5)
    column.SetRadius(0.28), column.SetHeight(4), column.SetResolution(32)
    pane.SetOrigin(-8, 0, -2.6), pane.SetPoint1(8, 0, -2.6), pane.SetPoint2(-8, 4, -2.6)
    beam.SetXLength(18), beam.SetYLength(0.7), beam.SetZLength(1.2)
    add(renderer, floor, (0, 0, 0), (0.70, 0.62, 0.52))
    for i in range(5):
        add(renderer, column, (4 * i - 8, 2, -2.5), (0.84, 0.80, 0.72))
    add(renderer, beam, (0, 4.35, -2.5), (0.84, 0.80, 0.72))
    # What a renderer draws of this is there before people are: they stand in front of it.
    add(renderer, pane, (0, 0, 0), (0.45, 0.62, 0.60), opacity=0.5)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE), camera.SetFocalPoint(*AT), camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(FOV_DEG), camera.SetClippingRange(NEAR, FAR)
    return renderer


def sign():
    """A second renderer, which VTK draws over the first one when people are in its picture."""
    renderer, cube = vtkRenderer(), vtkCubeSource()
    renderer.SetLayer(1)
    renderer.SetViewport(*SIGN)
    add(renderer, cube, (0, 0, 0), (0.75, 0.25, 0.2))
    add(renderer, cube, (0.7, 0.3, 0.6), (0.95, 0.8, 0.3), opacity=0.6)
    renderer.GetActiveCamera().SetPosition(2, 1.5, 3)
    renderer.ResetCamera()
    return renderer


def window_of(renderer):
    """VTK in the context that is current: it makes none, and swaps nothing."""
    window = vtkGenericOpenGLRenderWindow()
    window.SetSize(WIDTH, HEIGHT)
    window.SetIsCurrent(True), window.SetReadyForRendering(True), window.SetSupportsOpenGL(1), window.SetIsDirect(1)
    window.SetMultiSamples(0), window.SetForceMaximumHardwareLineWidth(1.0), window.SwapBuffersOff()
    window.SetNumberOfLayers(2)
    window.AddRenderer(renderer)
    window.AddRenderer(sign())
    return window


def populate(crowd, *templates):
    chance = random.Random(2)
    for i in range(40):
        actor = crowd.add(templates[i % len(templates)], (chance.uniform(-7, 7), 0, chance.uniform(-2, 3.5)),
                          heading_rad=chance.uniform(-1, 1), clip="applaud" if i % 4 == 0 else "stand", seed=i)
        actor.randomise_colours()


def picture(window):
    """What VTK's own means of saving a picture see."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.SetShouldRerender(False)
    image.Update()
    return image.GetOutput()


def main():
    target = GlutWindow()
    renderer = scenery()
    window = window_of(renderer)
    window.Render()  # VTK makes what it needs; claque's textures must not meet its bindings
    with claque.Context() as context:
        names = ("citizen", "patrician", "plebeian")
        templates = [claque.Template.builtin(context, name, levels=True) for name in names]
        with claque.Crowd(context) as crowd, claque.Renderer(context, target) as drawer:
            drawer.prepare(*templates)
            populate(crowd, *templates)
            target.light()
            guest = Guest(target, crowd, drawer)
            renderer.AddObserver("EndEvent", guest.draw)
            window.Render()
            if guest.failure:
                raise SystemExit(guest.failure)
            writer = vtkPNGWriter()
            writer.SetFileName(sys.argv[1])
            writer.SetInputData(picture(window))
            writer.Write()
            print(f"{guest.drawn} people in {sys.argv[1]}")
            renderer.RemoveAllObservers()
        for template in templates:
            template.close()


if __name__ == "__main__":
    main()
